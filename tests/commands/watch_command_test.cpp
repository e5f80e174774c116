// `meshgrade watch`: what it notices, and what it says.

#include "grader/commands/watch_command.h"

#include "grader/commands/console.h"
#include "grader/commands/file_watch.h"
#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Report report_of(Verdict verdict, double points) {
  Report report;
  ExerciseReport exercise;
  exercise.name = "edge_flip";
  exercise.verdict = verdict;
  exercise.points = points;
  report.exercises.push_back(exercise);
  return report;
}

TEST(ChangesText, NamesVerdictsAndPoints) {
  const Report failed = report_of(Verdict::kFailed, 3.0);
  const Report passed = report_of(Verdict::kPassed, 20.0);
  EXPECT_EQ(changes_text(failed, passed), "edge_flip: failed -> passed (+17)\n");
  EXPECT_EQ(changes_text(passed, failed), "edge_flip: passed -> failed (-17)\n");
  EXPECT_EQ(changes_text(failed, report_of(Verdict::kFailed, 6.0)), "edge_flip: failed (+3)\n");
  EXPECT_EQ(changes_text(failed, failed), "nothing has changed\n");
}

class FileWatchTest : public CommandLine {
 protected:
  FileWatchTest() { write("edge_flip.cpp", "one"); }

  /// Whether a change is noticed within a second.
  static bool notices(FileWatch& watch) {
    int looks = 0;
    return watch.wait_for_change([&looks] { return ++looks > 20; });
  }
};

TEST_F(FileWatchTest, NoticesAWrittenFileOnce) {
  FileWatch watch(folder_);
  EXPECT_FALSE(notices(watch));
  write("edge_flip.cpp", "two, longer");
  EXPECT_TRUE(notices(watch));
  EXPECT_FALSE(notices(watch));
}

TEST_F(FileWatchTest, NoticesNewGoneAndReplacedFiles) {
  FileWatch watch(folder_);
  write("edge_split.cpp", "new");
  EXPECT_TRUE(notices(watch));
  fs::remove(folder_ / "edge_split.cpp");
  EXPECT_TRUE(notices(watch));
  write("edge_flip.cpp.new", "written aside, then renamed");
  fs::rename(folder_ / "edge_flip.cpp.new", folder_ / "edge_flip.cpp");
  EXPECT_TRUE(notices(watch));
}

TEST_F(FileWatchTest, LeavesOutWhatEditorsPutAside) {
  FileWatch watch(folder_);
  write(".edge_flip.cpp.swp", "notes");
  write("edge_flip.cpp~", "backup");
  EXPECT_FALSE(notices(watch));
}

TEST_F(FileWatchTest, SurvivesAFolderThatGoes) {
  FileWatch watch(folder_);
  fs::remove_all(folder_);
  EXPECT_TRUE(notices(watch));
  EXPECT_FALSE(notices(watch));
}

class WatchCommand : public CommandLine {
 protected:
  static constexpr const char* kChecked = "grep -q points \"$0\"";
};

TEST_F(WatchCommand, TellsOfAWrongFolderOrExerciseAtOnce) {
  EXPECT_EQ(call({"watch", (folder_ / "nowhere").string()}).status, 2);
  EXPECT_EQ(call({"watch", reference(), "edge_flop"}).status, 2);
}

TEST_F(WatchCommand, ChecksAndEndsWithZeroOnCtrlC) {
  const Said said = call_and_interrupt(kChecked, {"watch", reference(), "bezier_curve"});
  EXPECT_EQ(said.status, 0) << said.output;
  EXPECT_THAT(said.output, HasSubstr("10 of 10 points"));
}

/// A flip that takes its whole time in every case.
std::string endless(const std::string& folder) {
  std::ofstream(folder + "/edge_flip.cpp")
      << "#include \"meshedit/meshedit.h\"\nnamespace meshedit {\n"
         "EdgeIter HalfedgeMesh::flipEdge(EdgeIter e) { for (;;) std::cin.get(); return e; "
         "}\n}\n";
  return folder;
}

TEST_F(WatchCommand, EndsTheCheckThatRunsOnCtrlC) {
  const std::string folder = endless(folder_.string());
  const Said said =
      call_and_interrupt("grep -q watching \"$0\"", {"watch", folder, "edge_flip"});
  EXPECT_EQ(said.status, 0) << said.output;
  EXPECT_THAT(said.output, testing::Not(HasSubstr("points")));
}

TEST_F(WatchCommand, BeginsAnewWhenAFileIsSavedDuringTheCheck) {
  const std::string folder = endless(folder_.string());
  const std::string mended = shell_word(folder + "/mended");
  const std::string save = "{ [ -e " + mended + " ] || { cp " +
                           shell_word(std::string(reference()) + "/edge_flip.cpp") + " " +
                           shell_word(folder) + " && touch " + mended + "; }; }";
  const Said said = call_and_interrupt(
      "grep -q watching \"$0\" && " + save + " && grep -q 'of 20 points' \"$0\"",
      {"watch", folder, "edge_flip"});
  EXPECT_THAT(said.output, HasSubstr("20 of 20 points"));
  EXPECT_THAT(said.output, testing::Not(HasSubstr(" 0 of 20 points")));
}

TEST_F(WatchCommand, NamesACommandThatShowsAll) {
  const std::string folder = wrong("edge_flip/next_forgotten");
  const Said said = call_and_interrupt(kChecked, {"watch", folder, "edge_flip"});
  EXPECT_THAT(said.output, HasSubstr("more finding"));
  EXPECT_THAT(said.output,
              HasSubstr("./meshgrade check " + shell_word(folder) + " --verbose shows all"));
}

}  // namespace
}  // namespace meshgrade
