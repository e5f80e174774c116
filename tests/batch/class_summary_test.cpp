// The summary of a class, and what changed when it is graded again.

#include "grader/batch/class_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "grader/batch/class_diff.h"
#include "tests/batch/made_up_class.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What became of a class of those texts.
struct GradedClass {
  explicit GradedClass(const MadeUpClass::Texts& texts) : made(texts) {
    made.run();
    results =
        collect_results(read_roster(made.submissions(), {}), one_exercise(), {}, made.store());
  }

  MadeUpClass made;
  ClassResults results;
};

TEST(ClassSummary, CountsAndMeasures) {
  GradedClass graded(
      {{"ann", "10"}, {"bob", "0"}, {"cem", "9.9"}, {"dan", "5"}, {"eve", "throw"}});
  graded.results.rows[1].late = true;
  const ClassSummary summary = summarize(graded.results, graded.made.store());
  EXPECT_EQ(summary.statuses.at("graded"), 4U);
  EXPECT_EQ(summary.statuses.at("grader error"), 1U);
  EXPECT_DOUBLE_EQ(summary.mean, 24.9 / 4.0);
  EXPECT_DOUBLE_EQ(summary.median, (5.0 + 9.9) / 2.0);
  EXPECT_EQ(summary.lowest, 0.0);
  EXPECT_EQ(summary.highest, 10.0);
  EXPECT_EQ(summary.late, 1U);
  EXPECT_THAT(summary.distribution, ElementsAre(1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1));
  EXPECT_EQ(summary.exercises.at(0).full, 1U);
  EXPECT_EQ(summary.not_graded.at(0).key, "eve");
  EXPECT_EQ(summary.not_graded.at(0).why, "grader error: out of ideas");
  EXPECT_THAT(to_text(summary), HasSubstr("Points of 10: mean 6.225, median 7.45"));
  EXPECT_EQ(nlohmann::json::parse(to_json(summary)).at("schema"), "meshgrade-summary/1");
}

TEST(ClassSummary, NamesWhoHasPointsThatWereNotJudged) {
  GradedClass graded({{"ann", "10"}, {"bob", "0"}});
  graded.results.rows[1].exercises.at(0).verdict = "not judged";
  const ClassSummary summary = summarize(graded.results, graded.made.store());
  ASSERT_EQ(summary.undecided.size(), 1U);
  EXPECT_EQ(summary.undecided[0].key, "bob");
  EXPECT_THAT(summary.undecided[0].why, HasSubstr(", 10 points"));
  EXPECT_THAT(to_text(summary), HasSubstr("\nNot judged: a person has to decide\n  bob: "));
}

TEST(ClassSummary, LateWorkIsTakenOffVisibly) {
  GradedClass graded({{"ann", "10"}, {"bob", "0.5"}, {"cem", "8"}});
  Roster roster = read_roster(graded.made.submissions(), {});
  roster.hand_ins[0].submitted_at = "2026-03-02 13:00:00Z";
  roster.hand_ins[1].submitted_at = "2026-03-02 13:00:00Z";
  const auto rule =
      parse_late_rule("[late]\ndue = 2026-03-01T12:00:00Z\nper_day = \"10 %\"\n", "a.toml");
  const ClassResults results =
      collect_results(roster, one_exercise(), {}, graded.made.store(), rule);
  EXPECT_EQ(results.rows[0].points, 8.0);
  EXPECT_EQ(results.rows[0].points_before_late(), 10.0);
  EXPECT_EQ(results.rows[1].points, 0.0) << "never below zero";
  EXPECT_EQ(results.rows[2].points, 8.0) << "no time is known";
  const ClassResults read = read_class_results(to_json(results));
  EXPECT_EQ(read.rows[0].late_deduction, 2.0);
  EXPECT_EQ(read.rows[0].late_note, "1 day 1 h after it was due");
  const ClassSummary summary = summarize(results, graded.made.store());
  EXPECT_EQ(summary.late, 2U);
  EXPECT_THAT(to_text(summary),
              HasSubstr("\nLate\n  ann: 10 - 2 = 8 points: 1 day 1 h after it was due\n"));
  EXPECT_THAT(to_text(summary), HasSubstr("1 hand-in without a time: nothing is taken off"));
}

TEST(ClassSummary, ResultsOfAnEarlierVersionAreRead) {
  const GradedClass graded(MadeUpClass::Texts{{"ann", "10"}});
  nlohmann::json old = nlohmann::json::parse(to_json(graded.results));
  old["rows"][0].erase("late_deduction");
  old["rows"][0].erase("late_note");
  EXPECT_EQ(read_class_results(old.dump()).rows.at(0).points_before_late(), 10.0);
}

TEST(ClassSummary, AClassOfNobodyHasOne) {
  const ScratchFolder folder;
  const ClassSummary summary = summarize({}, ResultStore(folder.path()));
  EXPECT_EQ(summary.mean, 0.0);
  EXPECT_NE(to_text(summary), "");
}

/// A report with one failed case that has these findings.
Report failed_with(const std::vector<std::string>& rules, const std::string& misconception) {
  Report report;
  ExerciseReport& exercise = report.exercises.emplace_back();
  exercise.name = "edge_flip";
  exercise.verdict = Verdict::kFailed;
  for (const char* id : {"edge_flip:basic/1", "edge_flip:basic/2"}) {
    CaseReport& c = exercise.cases.emplace_back();
    c.id = id;
    c.verdict = Verdict::kFailed;
    for (const std::string& rule : rules) {
      Finding finding;
      finding.rule = rule;
      finding.meaning = "meaning of " + rule;
      if (!misconception.empty()) finding.likely.push_back({misconception, "advice"});
      c.findings.push_back({finding, {}});
    }
  }
  return report;
}

TEST(ClassSummary, ARuleCountsOnceForEachHandIn) {
  const ScratchFolder folder;
  const ResultStore store(folder.path());
  ClassResults results;
  results.exercises = {{"edge_flip", "", 0.0, 10.0, 0.0, 0.0}};
  const auto add = [&](const std::string& key, const Report& report) {
    store.save({key, "", ResultStatus::kGraded, "", report}, "");
    ClassRow row;
    row.key = key;
    row.status = ResultStatus::kGraded;
    row.exercises = results.exercises;
    results.rows.push_back(row);
  };
  add("ann", failed_with({"anchor"}, ""));
  add("bob", failed_with({"next-face", "anchor"}, "twins-forgotten"));
  add("eve", failed_with({"malformed"}, ""));
  add("flo", failed_with({"process-limit"}, ""));
  const ClassSummary summary = summarize(results, store);
  ASSERT_EQ(summary.rules.size(), 4U);
  EXPECT_EQ(summary.rules[0].name, "anchor");
  EXPECT_THAT(summary.rules[0].keys, ElementsAre("ann", "bob"));
  EXPECT_EQ(summary.misconceptions.at(0).name, "twins-forgotten");
  EXPECT_THAT(summary.misconceptions[0].keys, ElementsAre("bob"));
  ASSERT_EQ(summary.suspicious.size(), 2U);
  EXPECT_EQ(summary.suspicious[0].key, "eve");
  EXPECT_EQ(summary.suspicious[1].key, "flo");
}

TEST(ClassSummary, ExtraCreditThatWasNotTriedBreaksNoRule) {
  const auto rules_with = [](std::size_t passed) {
    const ScratchFolder folder;
    const ResultStore store(folder.path());
    Report report = failed_with({"boundary"}, "");
    for (CaseReport& c : report.exercises[0].cases)
      c.group = "extra";
    GroupReport group;
    group.name = "extra";
    group.extra_credit = true;
    group.passed = passed;
    report.exercises[0].groups = {group};
    store.save({"ann", "", ResultStatus::kGraded, "", report}, "");
    ClassResults results;
    ClassRow row;
    row.key = "ann";
    row.status = ResultStatus::kGraded;
    results.rows.push_back(row);
    return summarize(results, store).rules.size();
  };
  EXPECT_EQ(rules_with(0), 0U);
  EXPECT_EQ(rules_with(1), 1U) << "who tried it is told what is wrong";
}

TEST(ClassDiff, NamesWhoChangedAndByHowMuch) {
  const GradedClass before({{"ann", "10"}, {"bob", "2"}, {"cem", "3"}, {"dan", "throw"}});
  const GradedClass after({{"ann", "10"}, {"bob", "7"}, {"dan", "4"}, {"eve", "1"}});
  const auto changes =
      compare_classes(before.results, before.made.store(), after.results, after.made.store());
  EXPECT_EQ(to_text(changes, 5),
            "bob: 2 points -> 7 points (+5)\n"
            "cem: 3 points -> not there (-3)\n"
            "dan: grader error -> 4 points (+4)\n"
            "eve: not there -> 1 points (+1)\n");
  EXPECT_THAT(
      compare_classes(before.results, before.made.store(), before.results, before.made.store()),
      IsEmpty());
}

TEST(ClassDiff, NamesTheCasesThatMadeTheDifference) {
  const ScratchFolder folder;
  const ResultStore old_store(folder.path() / "old");
  const ResultStore new_store(folder.path() / "new");
  Report report = failed_with({"anchor"}, "");
  old_store.save({"ann", "", ResultStatus::kGraded, "", report}, "");
  report.exercises[0].cases[1].verdict = Verdict::kPassed;
  new_store.save({"ann", "", ResultStatus::kGraded, "", report}, "");
  ClassRow row;
  row.key = "ann";
  row.status = ResultStatus::kGraded;
  row.exercises = {{"edge_flip", "failed", 0.0, 10.0, 0.0, 0.0}};
  ClassResults before;
  before.rows = {row};
  ClassResults after = before;
  after.rows[0].points = after.rows[0].exercises[0].points = 5.0;
  EXPECT_EQ(to_text(compare_classes(before, old_store, after, new_store), 5),
            "ann: 0 points -> 5 points (+5)\n"
            "  edge_flip:basic/2: failed -> passed\n");
}

}  // namespace
}  // namespace meshgrade
