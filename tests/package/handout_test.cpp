// The students' package is whole, and holds nothing of the solution.

#include "grader/package/handout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/text.h"
#include "grader/package/package_files.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path kProject = MESHGRADE_SOURCE_DIR;
const fs::path kAssignment = kProject / "grader" / "assignment.toml";

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

/// Whether a line tells something of the solution: the head of a loop over all points, or a
/// short line, could stand anywhere.
bool is_telling(const std::string& line) {
  return line.size() >= 32 && line.rfind("for (", 0) != 0;
}

/// The lines of the reference between its SOLUTION marks that tell something.
std::set<std::string> solution_lines() {
  std::set<std::string> lines;
  for (const auto& entry : fs::recursive_directory_iterator(kProject / "reference")) {
    if (!entry.is_regular_file()) continue;
    bool inside = false;
    for (const std::string& line : split_lines(read(entry.path()))) {
      if (line.find("// SOLUTION BEGIN") != std::string::npos) {
        inside = true;
      } else if (line.find("// SOLUTION END") != std::string::npos) {
        inside = false;
      } else if (const std::string text = trimmed(line); inside && is_telling(text)) {
        lines.insert(text);
      }
    }
  }
  return lines;
}

class Handout : public testing::Test {
 protected:
  Handout() : folder_(scratch_.path() / "handout") {
    write_handout({kProject, kAssignment}, folder_);
  }

  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      if (entry.is_regular_file())
        found[entry.path().lexically_relative(folder_).string()] = read(entry.path());
    }
    return found;
  }

  ScratchFolder scratch_;
  fs::path folder_;
};

TEST_F(Handout, HoldsNoLineOfTheSolution) {
  const std::set<std::string> solution = solution_lines();
  ASSERT_GT(solution.size(), 60U) << "are the marks of the reference found?";
  for (const auto& [file, text] : files()) {
    for (const std::string& line : split_lines(text))
      EXPECT_EQ(solution.count(trimmed(line)), 0U) << file << ": " << line;
  }
}

TEST_F(Handout, HoldsNeitherReferenceNorTestsNorInstructorsPages) {
  for (const auto& [file, text] : files()) {
    for (const char* room : {"reference/", "tests/", ".git/", "build/", "docs/adequacy",
                             "docs/instructor", "docs/maintainer"})
      EXPECT_NE(file.rfind(room, 0), 0U) << file;
  }
}

TEST_F(Handout, OpensInAContainer) {
  const auto container =
      nlohmann::json::parse(read(folder_ / ".devcontainer" / "devcontainer.json"));
  EXPECT_EQ(container.at("postCreateCommand"), "./meshgrade doctor");
  EXPECT_NE(read(folder_ / "Containerfile").find("RUN /opt/meshgrade/meshgrade doctor"),
            std::string::npos);
}

TEST_F(Handout, HasEveryFileThatTheBuildNeeds) {
  Command configure;
  configure.arguments = {"cmake", "--preset", "release"};
  configure.folder = folder_;
  const ProcessResult configured = run_process(configure);
  ASSERT_TRUE(configured.ok()) << configured.output;
  Command build;
  build.arguments = {"ninja", "-C", "build/release", "-n", "meshgrade"};
  build.folder = folder_;
  const ProcessResult planned = run_process(build);
  EXPECT_TRUE(planned.ok()) << planned.output;
}

TEST_F(Handout, HasEveryPageThatItsPagesLinkTo) {
  for (const auto& [file, text] : files()) {
    if (fs::path(file).extension() != ".md") continue;
    for (std::size_t at = 0; (at = text.find("](", at)) != std::string::npos;) {
      at += 2;
      const std::string link = text.substr(at, text.find_first_of(")#", at) - at);
      if (link.empty() || link.find("://") != std::string::npos) continue;
      EXPECT_TRUE(fs::exists(folder_ / fs::path(file).parent_path() / link))
          << file << " links to " << link;
    }
  }
}

TEST_F(Handout, KeepsTheScriptExecutable) {
  const auto may_run = fs::status(folder_ / "meshgrade").permissions() & fs::perms::owner_exec;
  EXPECT_NE(may_run, fs::perms::none);
}

TEST_F(Handout, LeavesTheSeedOfHiddenCasesBehindWhereverItLies) {
  // A handout is whole enough to make a handout of; and it may be written to.
  const fs::path project = folder_;
  for (const std::string seed : {"grader/seed.txt", "meshes/seed.txt", "docs/pictures/seed"}) {
    const fs::path file = project / "grader" / "hidden.toml";
    std::ofstream(file) << read(kAssignment) << "\n[hidden]\nseed_file = \"../" << seed
                        << "\"\n";
    std::ofstream(project / seed) << "8205\n";
    fs::copy_file(kProject / "HANDOUT.md", project / "HANDOUT.md",
                  fs::copy_options::overwrite_existing);
    const fs::path target = scratch_.path() / fs::path(seed).parent_path().filename();
    write_handout({project, file}, target);
    EXPECT_TRUE(fs::exists(target / "grader" / "judge"));
    EXPECT_NE(read(target / "grader" / "assignment.toml").find(seed), std::string::npos);
    EXPECT_FALSE(fs::exists(target / seed));
    fs::remove(project / seed);
  }
}

TEST_F(Handout, HasTheInstructorsMeshesButNotTheHiddenOnes) {
  const fs::path course = scratch_.path() / "course";
  fs::create_directories(course / "ours");
  for (const char* name : {"seen.obj", "secret.obj"})
    fs::copy_file(kProject / "meshes" / "fan.obj", course / "ours" / name);
  std::ofstream(course / "a.toml")
      << "version = 1\ntitle = \"T\"\nseed = 1\n[[exercise]]\nname = \"edge_flip\"\n"
         "[[exercise.group]]\nname = \"basic\"\npoints = 1\n"
         "[[exercise.group.mesh]]\nfile = \"ours/seen.obj\"\n"
         "[[exercise.group.mesh]]\nfile = \"ours/secret.obj\"\nhidden = true\n";
  const fs::path target = scratch_.path() / "with_meshes";
  write_handout({kProject, course / "a.toml"}, target);
  EXPECT_TRUE(fs::exists(target / "grader" / "ours" / "seen.obj"));
  EXPECT_FALSE(fs::exists(target / "grader" / "ours" / "secret.obj"));
  const Assignment read = read_assignment(target / "grader" / "assignment.toml");
  EXPECT_TRUE(read.own_meshes().at(0).is_there);
  EXPECT_FALSE(read.own_meshes().at(1).is_there);
  const std::vector<PackagePart> parts =
      assignment_parts(read_assignment(course / "a.toml"), course / "a.toml", "a.toml", true);
  EXPECT_EQ(parts.size(), 3U) << "an autograder that students cannot look into has all";
}

TEST_F(Handout, IsNotWrittenOverAFolderWithFiles) {
  try {
    write_handout({kProject, kAssignment}, folder_);
    FAIL() << "no error";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is not empty"));
  }
}

}  // namespace
}  // namespace meshgrade
