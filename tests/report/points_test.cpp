// How points are added up.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grader/report/report.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;

Group group(const std::string& name, double points) {
  Group g;
  g.name = g.title = name;
  g.points = points;
  return g;
}

/// One exercise whose cases got these verdicts.
class Points : public testing::Test {
 protected:
  Points() { rubric_.name = rubric_.title = "edge_flip"; }

  void add(const Group& g, const std::vector<Verdict>& verdicts) {
    rubric_.groups.push_back(g);
    int number = 0;
    for (Verdict verdict : verdicts) {
      JudgedCase c;
      c.asked.exercise = rubric_.name;
      c.asked.group = g.name;
      c.asked.number = ++number;
      c.judgement.verdict = verdict;
      judged_.cases.push_back(c);
    }
  }

  Report report() {
    judged_.rubric = &rubric_;
    return make_report(Assignment{}, Submission{}, {}, {judged_, judged_});
  }
  ExerciseReport exercise() { return report().exercises.at(0); }

  ExerciseRubric rubric_;
  JudgedExercise judged_;
};

constexpr Verdict kPass = Verdict::kPassed;
constexpr Verdict kFail = Verdict::kFailed;
constexpr Verdict kNone = Verdict::kNotJudged;

TEST_F(Points, GroupIsAllOrNothing) {
  add(group("all", 5), {kPass, kPass, kPass});
  add(group("most", 3), {kPass, kPass, kFail});
  EXPECT_EQ(exercise().points, 5.0);
  EXPECT_EQ(exercise().max_points, 8.0);
  EXPECT_EQ(exercise().groups[1].passed, 2U);
  EXPECT_EQ(exercise().groups[1].cases, 3U);
}

TEST_F(Points, PartialGroupGivesItsShareInHundredths) {
  Group g = group("g", 5);
  g.partial = Partial::kCases;
  add(g, {kPass, kPass, kFail});
  EXPECT_EQ(exercise().points, 3.33);
}

TEST_F(Points, PointersThatAreRightEarnAtMostFourFifths) {
  Group g = group("basic", 10);
  g.partial = Partial::kPointers;
  add(g, {kPass, kFail, Verdict::kCrashed});
  EXPECT_EQ(exercise().points, 0.0);
  EXPECT_THAT(exercise().groups[0].why, HasSubstr("nothing that must change is right"));
  judged_.cases[1].judgement.right_share = 1.0;
  EXPECT_EQ(exercise().points, 4.0);  // half of four fifths of 10
  EXPECT_EQ(exercise().groups[0].why, "");
}

TEST_F(Points, WhyAGroupEarnsNothingIsSaid) {
  Group g = group("boundary", 3);
  g.needs = "basic";
  add(group("basic", 6), {kPass, kFail});
  add(g, {kPass});
  EXPECT_EQ(exercise().groups[0].why, "counts only if all of its cases pass");
  EXPECT_EQ(exercise().groups[1].why, "counts only if basic earns points");
}

TEST_F(Points, ExtraCreditIsCountedApart) {
  Group g = group("bonus", 4);
  g.extra_credit = true;
  add(group("basic", 6), {kFail});
  add(g, {kPass});
  EXPECT_EQ(exercise().points, 0.0);
  EXPECT_EQ(exercise().max_points, 6.0);
  EXPECT_EQ(exercise().extra_points, 4.0);
  EXPECT_EQ(exercise().max_extra_points, 4.0);
}

TEST_F(Points, FailureInExtraCreditDoesNotSpoilTheVerdict) {
  Group g = group("bonus", 4);
  g.extra_credit = true;
  add(group("basic", 6), {kPass});
  add(g, {kFail});
  EXPECT_EQ(exercise().verdict, Verdict::kPassed);
}

TEST_F(Points, NeededGroupThatEarnsNothingTakesThePointsAway) {
  Group g = group("boundary", 3);
  g.needs = "basic";
  add(group("basic", 6), {kFail});
  add(g, {kPass});
  EXPECT_EQ(exercise().points, 0.0);
}

TEST_F(Points, NeededGroupThatEarnsSomethingIsEnough) {
  Group basic = group("basic", 6);
  basic.partial = Partial::kCases;
  Group g = group("boundary", 3);
  g.needs = "basic";
  add(basic, {kPass, kFail});
  add(g, {kPass});
  EXPECT_EQ(exercise().points, 6.0);
}

TEST_F(Points, CasesThatAreNotJudgedEarnNothing) {
  add(group("some", 5), {kPass, kNone});
  EXPECT_EQ(exercise().points, 0.0);
  EXPECT_EQ(exercise().verdict, Verdict::kNotJudged);
}

TEST_F(Points, ExcusedCasesDoNotCount) {
  add(group("some", 5), {kPass, kNone});
  add(group("none", 3), {kNone, kNone});
  for (JudgedCase& c : judged_.cases)
    c.judgement.excused = c.judgement.verdict == kNone;
  EXPECT_EQ(exercise().points, 5.0);
  EXPECT_EQ(exercise().groups[0].judged, 1U);
  EXPECT_EQ(exercise().groups[1].judged, 0U);
  EXPECT_EQ(exercise().verdict, Verdict::kPassed);
}

TEST_F(Points, AnExerciseWithoutAJudgedCaseIsNotPassed) {
  add(group("none", 3), {kNone, kNone});
  for (JudgedCase& c : judged_.cases)
    c.judgement.excused = true;
  EXPECT_EQ(exercise().verdict, Verdict::kNotJudged);
}

TEST_F(Points, ReportIsTheSumOfItsExercises) {
  add(group("basic", 6), {kPass});
  EXPECT_EQ(report().points, 12.0);
  EXPECT_EQ(report().max_points, 12.0);
}

TEST_F(Points, VerdictIsThatOfTheFirstFailure) {
  add(group("a", 1), {kPass, kNone, Verdict::kCrashed, kFail});
  EXPECT_EQ(exercise().verdict, Verdict::kCrashed);
}

TEST_F(Points, ErrorOfTheGraderStandsOut) {
  add(group("a", 1), {kFail, Verdict::kGraderError});
  EXPECT_EQ(exercise().verdict, Verdict::kGraderError);
  EXPECT_TRUE(report().has_grader_error());
}

}  // namespace
}  // namespace meshgrade
