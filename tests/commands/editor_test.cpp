// `check --format gcc`, and the students' folder as an editor opens it.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const fs::path kSkeleton = fs::path(MESHGRADE_SOURCE_DIR) / "student_skeleton";

class Editor : public CommandLine {
 protected:
  /// The first line of that file with this text, from 1.
  static std::size_t line_with(const fs::path& file, const std::string& text) {
    const std::vector<std::string> lines = split_lines(read_whole_file(file));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].find(text) != std::string::npos) return i + 1;
    }
    ADD_FAILURE() << file << " does not have " << text;
    return 0;
  }

  static std::vector<std::string> messages(const std::string& submission,
                                           const std::string& exercise) {
    return split_lines(call({"check", submission, exercise, "--format", "gcc"}).output);
  }

  /// VS Code's problem matcher of the skeleton, without its comments.
  static std::vector<std::regex> matchers() {
    std::string text;
    for (const std::string& line :
         split_lines(read_whole_file(kSkeleton / ".vscode" / "tasks.json"))) {
      if (line.find_first_not_of(' ') != line.find("//")) text += line + "\n";
    }
    std::vector<std::regex> patterns;
    const nlohmann::json file = nlohmann::json::parse(text);
    for (const auto& task : file.at("tasks")) {
      const auto& matcher = task.at("problemMatcher");
      if (matcher.is_object())
        patterns.emplace_back(matcher.at("pattern").at("regexp").get<std::string>());
    }
    return patterns;
  }

  Said in_folder(const std::vector<std::string>& arguments) const {
    Command command;
    command.arguments = {"env", "MESHGRADE_PROGRAM=" MESHGRADE_PROGRAM};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    command.folder = folder_;
    command.time_limit = std::chrono::minutes(4);
    const ProcessResult result = run_process(command);
    return {result.status, result.output};
  }

  void copy_skeleton() const {
    fs::copy(kSkeleton, folder_, fs::copy_options::recursive);
    fs::remove_all(folder_ / "build");
  }
};

TEST_F(Editor, AWrongResultStandsAtItsFunction) {
  const std::string folder = wrong("edge_flip/next_wrong");
  const fs::path file = fs::path(folder) / "edge_flip.cpp";
  const std::string place =
      file.string() + ":" + std::to_string(line_with(file, "HalfedgeMesh::flipEdge("));
  const auto lines = messages(folder, "edge_flip");
  ASSERT_GE(lines.size(), 3U);
  EXPECT_THAT(lines[0], StartsWith(place + ":1: error: edge_flip: "));
  EXPECT_THAT(lines[0], HasSubstr("expected: "));
  EXPECT_THAT(lines[1], StartsWith(place + ":1: note: "));
  EXPECT_THAT(lines.back(), AllOf(StartsWith("next_wrong: "), HasSubstr(" of 20 points")));
}

TEST_F(Editor, ACrashStandsAtItsOwnLine) {
  const std::string folder = wrong("edge_flip/throws");
  const fs::path file = fs::path(folder) / "edge_flip.cpp";
  const std::size_t line = line_with(file, ".at(");
  const std::string text = split_lines(read_whole_file(file))[line - 1];
  EXPECT_THAT(messages(folder, "edge_flip")[0],
              StartsWith(file.string() + ":" + std::to_string(line) + ":" +
                         std::to_string(text.find_first_not_of(' ') + 1) + ": error: "));
}

TEST_F(Editor, OfSeveralFunctionsTheOneThatTheCaseCallsIsNamed) {
  const std::string folder = wrong("bezier_patch/net_transposed");
  const fs::path file = fs::path(folder) / "bezier_patch.cpp";
  EXPECT_THAT(
      messages(folder, "bezier_patch")[0],
      StartsWith(file.string() + ":" +
                 std::to_string(line_with(file, "BezierPatch::evaluate(double")) + ":"));
}

TEST_F(Editor, WhatTheCompilerSaysNamesTheFileAsOneReachesIt) {
  const std::string folder = wrong("edge_flip/does_not_compile");
  const auto lines = messages(folder, "edge_flip");
  const auto is_error = [&](const std::string& line) {
    return line.find(": error: ") != std::string::npos;
  };
  const auto error = std::find_if(lines.begin(), lines.end(), is_error);
  ASSERT_NE(error, lines.end());
  EXPECT_THAT(*error, StartsWith(folder + "/edge_flip.cpp:"));
  EXPECT_EQ(
      std::count_if(lines.begin(), lines.end(),
                    [&](const std::string& line) { return line.find("meshgrade: ") == 0; }),
      0);
}

TEST_F(Editor, WhatIsNotWrittenYetIsAWarning) {
  const auto lines = messages(kSkeleton.string(), "edge_flip");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_THAT(lines[0], HasSubstr("/edge_flip.cpp:"));
  EXPECT_THAT(lines[0], HasSubstr(": warning: edge_flip: "));
}

TEST_F(Editor, FullPointsAreOneLine) {
  EXPECT_THAT(messages(reference(), "bezier_curve"), ElementsAre("reference: 10 of 10 points"));
}

TEST_F(Editor, AnArchivesFilesAreNamedAsTheyAreInIt) {
  fs::copy_file(wrong("edge_flip/next_wrong") + "/edge_flip.cpp", folder_ / "edge_flip.cpp");
  ASSERT_EQ(in_folder({"tar", "-cf", "../hw.tar", "edge_flip.cpp"}).status, 0);
  EXPECT_THAT(messages((folder_.parent_path() / "hw.tar").string(), "edge_flip")[0],
              StartsWith("edge_flip.cpp:"));
}

TEST_F(Editor, TheTasksOfVsCodeReadEveryMessage) {
  const auto lines = messages(wrong("edge_flip/next_wrong"), "edge_flip");
  const auto patterns = matchers();
  ASSERT_EQ(patterns.size(), 2U);
  for (const std::regex& pattern : patterns) {
    for (std::size_t i = 0; i + 1 < lines.size(); ++i)
      EXPECT_TRUE(std::regex_match(lines[i], pattern)) << lines[i];
    EXPECT_FALSE(std::regex_match(lines.back(), pattern)) << lines.back();
  }
}

TEST_F(Editor, ACopyOfTheSkeletonFindsTheMeshgradeThatGradedLast) {
  copy_skeleton();
  const Said before = in_folder({"cmake", "--preset", "default"});
  EXPECT_NE(before.status, 0);
  EXPECT_THAT(before.output, HasSubstr("Where is Meshgrade?"));
  call({"check", folder_.string(), "bezier_curve"});
  const Said after = in_folder({"cmake", "--preset", "default"});
  ASSERT_EQ(after.status, 0) << after.output;
  const Said graded =
      in_folder({"cmake", "--build", "--preset", "default", "--target", "grade_edge_flip"});
  EXPECT_THAT(graded.output, HasSubstr((folder_ / "edge_flip.cpp").string() + ":"));
  EXPECT_THAT(graded.output, HasSubstr(": warning: edge_flip: "));
}

}  // namespace
}  // namespace meshgrade
