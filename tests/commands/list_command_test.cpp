// What is remembered of a check, and `meshgrade list`, which shows it.

#include "grader/commands/list_command.h"

#include "grader/commands/context.h"
#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

using testing::ContainsRegex;

class ListCommand : public CommandLine {
 protected:
  static Report report(Verdict verdict, double points) {
    Report report;
    ExerciseReport exercise;
    exercise.name = "edge_flip";
    exercise.verdict = verdict;
    exercise.points = points;
    report.exercises.push_back(exercise);
    return report;
  }

  ProgressStore store_{scratch_.path() / "store"};
};

TEST_F(ListCommand, AStoreGivesBackWhatItWasGiven) {
  store_.remember(folder_, report(Verdict::kFailed, 14.0));
  const ExerciseProgress kept = store_.load(folder_).exercises.at("edge_flip");
  EXPECT_EQ(kept.verdict, "failed");
  EXPECT_EQ(kept.points, 14.0);
  EXPECT_EQ(store_.last_submission()->filename(), folder_.filename());
}

TEST_F(ListCommand, ACheckKeepsTheHintsThatWereCounted) {
  SubmissionProgress progress = store_.load(folder_);
  progress.exercises["edge_flip"].hints = 3;
  store_.save(progress);
  store_.remember(folder_, report(Verdict::kPassed, 20.0));
  EXPECT_EQ(store_.load(folder_).exercises.at("edge_flip").hints, 3U);
}

TEST_F(ListCommand, TwoFoldersOfOneNameAreTwoSubmissions) {
  store_.remember(folder_ / "a" / "homework", report(Verdict::kPassed, 20.0));
  EXPECT_TRUE(store_.load(folder_ / "b" / "homework").exercises.empty());
  EXPECT_FALSE(store_.load(folder_ / "a" / "homework" / "").exercises.empty());
}

TEST_F(ListCommand, ABrokenFileCountsAsNothingRemembered) {
  store_.remember(folder_, report(Verdict::kPassed, 20.0));
  for (const auto& entry : std::filesystem::directory_iterator(scratch_.path() / "store"))
    std::ofstream(entry.path()) << "{\"exercises\": 3}";
  EXPECT_TRUE(store_.load(folder_).exercises.empty());
}

TEST_F(ListCommand, TheTableAddsUpAndTellsTheTime) {
  const Assignment assignment = read_assignment(standard_assignment());
  SubmissionProgress progress;
  progress.exercises["edge_flip"] = {"passed", 20.0, 20.0, 0.0, 0.0, 1000, 2};
  const std::string table = progress_table(assignment, progress, 1000 + 2 * 3600);
  EXPECT_THAT(table, ContainsRegex("edge_flip +passed +20 / 20 +2 +2 hours ago\n"));
  EXPECT_THAT(table, ContainsRegex("edge_split +- +0 / 20 +0 / 5 +never\n"));
  EXPECT_THAT(table, ContainsRegex("total +20 / 100 +0 / 10\n"));
}

TEST_F(ListCommand, ShowsTheLastCheck) {
  EXPECT_EQ(call({"list"}).status, 2);
  call({"check", reference(), "bezier_curve"});
  const Said said = call({"list"});
  EXPECT_EQ(said.status, 0);
  EXPECT_THAT(said.output, ContainsRegex("bezier_curve +passed +10 / 10 +just now"));
}

}  // namespace
}  // namespace meshgrade
