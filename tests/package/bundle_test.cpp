// Each bundle is unpacked into a folder tree like the real host's and run there, up to the
// result file. Only the build of the grader is left out: MESHGRADE_PROGRAM names one.

#include "grader/package/bundle.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/package/archive_writer.h"
#include "grader/submission/archive.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

const fs::path kBundledProject = MESHGRADE_SOURCE_DIR;
const fs::path kBundledAssignment = kBundledProject / "grader" / "assignment.toml";

class Bundle : public testing::Test {
 protected:
  Bundle() { ::setenv("MESHGRADE_PROGRAM", MESHGRADE_PROGRAM, 1); }
  ~Bundle() override { ::unsetenv("MESHGRADE_PROGRAM"); }

  /// Unpacks as hosts do that keep no permissions.
  void unpack(const std::string& host, const fs::path& folder) const {
    const fs::path file = scratch_.path() / (host + ".zip");
    write_bundle(host, {kBundledProject, kBundledAssignment}, file);
    fs::create_directories(folder);
    unpack_archive(file, folder,
                   {std::uint64_t{1} << 30U, std::uint64_t{1} << 28U, 10'000, 30});
  }

  /// Hands in this file of the reference, as it is or with something appended.
  static void hand_in(const fs::path& folder, const std::string& file,
                      const std::string& more = "") {
    fs::create_directories(folder);
    write_file_safely(folder / file,
                      read_whole_file(kBundledProject / "reference" / file) + more);
  }

  static std::string run(const fs::path& folder, std::vector<std::string> arguments) {
    Command command;
    command.arguments = std::move(arguments);
    command.folder = folder;
    command.time_limit = std::chrono::minutes(4);
    const ProcessResult result = run_process(command);
    EXPECT_TRUE(result.ok()) << result.output;
    return result.output;
  }

  ScratchFolder scratch_;
};

// PrairieLearn, for one, starts its script by its name. Archives keep what a file may do.
TEST_F(Bundle, ScriptsMayRunWherePermissionsAreKept) {
  int scripts = 0;
  for (const auto& entry :
       fs::recursive_directory_iterator(kBundledProject / "grader" / "package" / "hosts")) {
    if (!entry.is_regular_file()) continue;
    if (read_whole_file(entry.path()).rfind("#!", 0) != 0) continue;
    ++scripts;
    EXPECT_NE(entry.status().permissions() & fs::perms::owner_exec, fs::perms::none)
        << entry.path();
  }
  EXPECT_EQ(scripts, 5);
}

TEST_F(Bundle, AFileThatCannotBeWrittenIsNamedAsItWasGiven) {
  const fs::path file = scratch_.path() / "missing" / "x.zip";
  const std::string error =
      user_error([&] { write_archive(kBundledProject / "student_skeleton", file); });
  EXPECT_EQ(error, file.string() +
                       ": cannot be written: No such file or directory; make the folder first");
}

TEST_F(Bundle, OfGradescopeWritesItsResults) {
  const fs::path root = scratch_.path() / "autograder";
  unpack("gradescope", root / "source");
  run(root / "source", {"bash", "setup.sh"});
  fs::copy_file(root / "source" / "run_autograder", root / "run_autograder");
  fs::create_directories(root / "results");
  hand_in(root / "submission", "bezier_curve.cpp");
  run(root, {"bash", "run_autograder"});
  const json results = json::parse(read_whole_file(root / "results" / "results.json"));
  EXPECT_EQ(results.at("score"), 10.0);
  EXPECT_GT(results.at("tests").size(), 10U);
}

TEST_F(Bundle, OfGradescopeGivesAnEmptyFolderNoPointsAndSaysWhy) {
  const fs::path root = scratch_.path() / "autograder";
  unpack("gradescope", root / "source");
  fs::copy_file(root / "source" / "run_autograder", root / "run_autograder");
  fs::create_directories(root / "results");
  fs::create_directories(root / "submission");
  run(root, {"bash", "run_autograder"});
  const json results = json::parse(read_whole_file(root / "results" / "results.json"));
  EXPECT_EQ(results.at("score"), 0.0);
  EXPECT_THAT(results.at("output").get<std::string>(), HasSubstr("ungradable"));
}

TEST_F(Bundle, OfAutolabPrintsTheScoresLast) {
  const fs::path upload = scratch_.path() / "upload";
  unpack("autolab", upload);
  // Autolab copies both files and the hand-in to one folder, and calls make there.
  const fs::path job = scratch_.path() / "job";
  hand_in(scratch_.path() / "own", "bezier_curve.cpp");
  fs::create_directories(job);
  write_archive(scratch_.path() / "own", job / "handin.tar");
  fs::copy_file(upload / "autograde.tar", job / "autograde.tar");
  fs::copy_file(upload / "autograde-Makefile", job / "Makefile");
  const std::vector<std::string> lines = split_lines(run(job, {"make", "-s"}));
  ASSERT_FALSE(lines.empty());
  const json scores = json::parse(lines.back());
  EXPECT_EQ(scores.at("scores").at("bezier_curve"), 10.0);
}

TEST_F(Bundle, OfGithubWritesRemarksSummaryAndResult) {
  const fs::path repository = scratch_.path() / "work" / "homework";
  unpack("github", repository);
  hand_in(repository, "bezier_curve.cpp", "int broken = ;\n");
  const fs::path summary = scratch_.path() / "summary.md";
  const fs::path output = scratch_.path() / "output.txt";
  const std::string printed =
      run(repository, {"env", "GITHUB_STEP_SUMMARY=" + summary.string(),
                       "GITHUB_OUTPUT=" + output.string(), "bash", ".meshgrade/grade.sh"});
  EXPECT_THAT(printed, HasSubstr("::error file=bezier_curve.cpp,"));
  EXPECT_THAT(read_whole_file(summary), HasSubstr("bezier_curve"));
  EXPECT_THAT(read_whole_file(output), HasSubstr("result="));
  EXPECT_TRUE(fs::exists(repository / ".github" / "workflows" / "meshgrade.yml"));
}

TEST_F(Bundle, OfGithubHoldsNoReference) {
  const fs::path repository = scratch_.path() / "homework";
  unpack("github", repository);
  for (const auto& entry : fs::recursive_directory_iterator(repository))
    EXPECT_NE(entry.path().filename(), "reference") << entry.path();
}

TEST_F(Bundle, OfPrairieLearnWritesItsResults) {
  unpack("prairielearn", scratch_.path() / "bundle");
  const fs::path grade = scratch_.path() / "grade";
  fs::create_directories(grade);
  fs::copy(scratch_.path() / "bundle" / "question" / "tests", grade / "tests");
  hand_in(grade / "student", "bezier_curve.cpp");
  const std::string home =
      "MESHGRADE_HOME=" + (scratch_.path() / "bundle" / "image" / "meshgrade").string();
  run(grade, {"env", home, "bash", (grade / "tests" / "run.sh").string()});
  const json results = json::parse(read_whole_file(grade / "results" / "results.json"));
  EXPECT_DOUBLE_EQ(results.at("score").get<double>(), 0.1);
}

TEST_F(Bundle, HoldsTheSeedOfHiddenCasesOnlyWhereStudentsCannotLook) {
  const fs::path folder = scratch_.path() / "assignment";
  fs::create_directories(folder);
  const fs::path assignment = folder / "hidden.toml";
  std::string text = read_whole_file(kBundledAssignment);
  text.insert(text.find("[limits]"), "[hidden]\nseed_file = \"the_seed\"\nshow = \"name\"\n\n");
  write_file_safely(assignment, text);
  write_file_safely(folder / "the_seed", "4711\n");
  for (const std::string host : {"gradescope", "github"}) {
    const fs::path file = scratch_.path() / (host + ".tar");
    write_bundle(host, {kBundledProject, assignment}, file);
    EXPECT_EQ(read_whole_file(file).find("the_seed", 0) == std::string::npos, false);
    const bool holds = read_whole_file(file).find("4711\n") != std::string::npos;
    EXPECT_EQ(holds, host == "gradescope") << host;
  }
}

TEST_F(Bundle, IsTheSameBytesEachTime) {
  const fs::path first = scratch_.path() / "a.zip";
  const fs::path second = scratch_.path() / "b.zip";
  write_bundle("gradescope", {kBundledProject, kBundledAssignment}, first);
  write_bundle("gradescope", {kBundledProject, kBundledAssignment}, second);
  EXPECT_EQ(read_whole_file(first), read_whole_file(second));
}

TEST_F(Bundle, RefusesAnUnknownHostAndAnUnknownKindOfFile) {
  EXPECT_THROW(
      write_bundle("moodle", {kBundledProject, kBundledAssignment}, scratch_.path() / "a.zip"),
      UserError);
  EXPECT_THROW(
      write_bundle("github", {kBundledProject, kBundledAssignment}, scratch_.path() / "a.rar"),
      UserError);
  EXPECT_THROW(write_bundle("github", {kBundledProject, kBundledAssignment},
                            scratch_.path() / "nowhere" / "a.zip"),
               UserError);
}

}  // namespace
}  // namespace meshgrade
