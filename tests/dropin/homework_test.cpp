// Homework written for Berkeley's skeleton is graded as it was handed in. tests/dropin/homework
// holds some, in the styles of different years and authors; the broken ones are made from them
// by one edit.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include "grader/app/context.h"
#include "grader/app/grading.h"

namespace meshgrade {
namespace {

const std::filesystem::path kHomework =
    std::filesystem::path(MESHGRADE_SOURCE_DIR) / "tests" / "dropin" / "homework";

using Verdicts = std::map<std::string, std::string>;

Submission hand_in(const std::string& folder) {
  return find_submission(kHomework / folder, SubmissionRules());
}

/// The homework `since_2020` with one part of it replaced.
Submission hand_in_with(const std::string& part, const std::string& replacement) {
  Submission submission = hand_in("since_2020");
  std::string& text = submission.sources.at(0).text;
  const std::size_t at = text.find(part);
  if (at == std::string::npos) ADD_FAILURE() << "the homework does not hold " << part;
  text.replace(at, part.size(), replacement);
  return submission;
}

Report grade_all(const Submission& submission) {
  return grade(read_assignment(standard_assignment()), submission, find_home(), {},
               [](const std::string&) {});
}

Verdicts verdicts(const Report& report) {
  Verdicts all;
  for (const ExerciseReport& exercise : report.exercises)
    all[exercise.name] = verdict_name(exercise.verdict);
  return all;
}

/// What exercises get that do not depend on flips and splits.
void expect_independent_exercises_passed(const Report& report) {
  Verdicts all = verdicts(report);
  for (const char* name : {"bezier_curve", "bezier_patch", "vertex_normal"})
    EXPECT_EQ(all[name], "passed") << name;
}

double points(const Report& report, const std::string& exercise) {
  for (const ExerciseReport& e : report.exercises) {
    if (e.name == exercise) return e.points;
  }
  return -1.0;
}

bool has_note(const Report& report, const std::string& part) {
  return std::any_of(report.notes.begin(), report.notes.end(), [&](const std::string& note) {
    return note.find(part) != std::string::npos;
  });
}

std::string folder_name(const testing::TestParamInfo<std::string>& tested) {
  return tested.param;
}

class RightHomework : public testing::TestWithParam<std::string> {};

TEST_P(RightHomework, GetsEveryPoint) {
  const Report report = grade_all(hand_in(GetParam()));
  EXPECT_EQ(report.points, report.max_points);
  for (const auto& [exercise, verdict] : verdicts(report))
    EXPECT_EQ(verdict, "passed") << exercise;
}

INSTANTIATE_TEST_SUITE_P(Years, RightHomework,
                         testing::Values("of_2017", "of_2019", "since_2020", "whole_project"),
                         folder_name);

TEST(Homework, BoundarySplitsEarnTheExtraCredit) {
  const Report report = grade_all(hand_in("of_2019"));
  EXPECT_EQ(report.extra_points, report.max_extra_points);
}

TEST(Homework, Of2016IsGradedWithoutItsBezierPart) {
  const Report report = grade_all(hand_in("of_2016"));
  EXPECT_EQ(verdicts(report), (Verdicts{{"bezier_curve", "not implemented"},
                                        {"bezier_patch", "not implemented"},
                                        {"vertex_normal", "passed"},
                                        {"edge_flip", "passed"},
                                        {"edge_split", "passed"},
                                        {"loop_subdivision", "passed"}}));
  EXPECT_TRUE(has_note(report, "2016; its Bezier functions are of another form"));
}

TEST(Homework, UntouchedSkeletonGetsNoPoints) {
  const Report report = grade_all(hand_in("untouched"));
  EXPECT_EQ(report.points, 0.0);
  EXPECT_FALSE(report.has_grader_error());
}

TEST(Homework, CourseProgramsAreLeftOutOfAWholeProject) {
  const Submission submission = hand_in("whole_project");
  ASSERT_EQ(submission.sources.size(), 1U);
  EXPECT_EQ(submission.sources[0].name, "student_code.cpp");
}

TEST(Homework, StudentHeaderComesAlong) {
  Submission submission = hand_in("since_2020");
  ASSERT_EQ(submission.headers.size(), 1U);
  submission.headers.clear();  // declares helpers that the source uses
  EXPECT_LT(grade_all(submission).points, 100.0);
}

TEST(BrokenFunction, CostsOnlyItself) {
  const Report report = grade_all(hand_in_with("Vector3D n(0, 0, 0);", "Vector3d n(0, 0, 0);"));
  EXPECT_EQ(verdicts(report)["vertex_normal"], "not compiled");
  EXPECT_EQ(report.points, report.max_points - 15.0);
  EXPECT_TRUE(has_note(report, "student_code.cpp:57: Vertex::normal does not compile"));
}

TEST(BrokenFunction, IsStoodInForByARightOneWhereItIsCalled) {
  const Report report =
      grade_all(hand_in_with("VertexIter m = newVertex();", "VertexIter m = newVertex()"));
  EXPECT_EQ(verdicts(report)["edge_split"], "not compiled");
  EXPECT_EQ(verdicts(report)["loop_subdivision"], "passed");
  EXPECT_EQ(points(report, "edge_flip"), 20.0);
  expect_independent_exercises_passed(report);
}

TEST(BrokenFunction, MayBeBrokenInItsHead) {
  const Report report =
      grade_all(hand_in_with("splitEdge( EdgeIter e0 )", "splitEdge( Edgy )"));
  EXPECT_EQ(verdicts(report)["edge_split"], "not compiled");
  EXPECT_EQ(points(report, "edge_flip"), 20.0);
  expect_independent_exercises_passed(report);
}

TEST(BrokenFunction, MayLackABrace) {
  const Report report =
      grade_all(hand_in_with("return EdgeIter();\n    }", "return EdgeIter();"));
  EXPECT_EQ(verdicts(report)["edge_flip"], "not compiled");
  EXPECT_EQ(points(report, "edge_split"), 20.0);
  expect_independent_exercises_passed(report);
}

TEST(BrokenFunction, MayHaveABraceTooMany) {
  const Report report =
      grade_all(hand_in_with("return EdgeIter();\n    }", "return EdgeIter();\n    }\n    }"));
  EXPECT_EQ(verdicts(report)["edge_flip"], "not compiled");
  EXPECT_EQ(points(report, "edge_split"), 20.0);
  expect_independent_exercises_passed(report);
}

TEST(BrokenFunction, MayBeTheLastThatLacksABrace) {
  const Report report = grade_all(
      hand_in_with("v->position = v->newPosition;\n    }", "v->position = v->newPosition;"));
  EXPECT_EQ(verdicts(report)["loop_subdivision"], "not compiled");
  EXPECT_EQ(points(report, "edge_split"), 20.0);
  expect_independent_exercises_passed(report);
}

TEST(BrokenFunction, MayCallWhatIsDefinedNowhere) {
  const Report report =
      grade_all(hand_in_with("Vector3D n(0, 0, 0);", "Vector3D zero(); Vector3D n = zero();"));
  EXPECT_EQ(verdicts(report)["vertex_normal"], "not compiled");
  EXPECT_EQ(report.points, report.max_points - 15.0);
}

TEST(BrokenFunction, MayBeAHelperOfOneExercise) {
  const Report report = grade_all(hand_in_with("Vector3D sum = 0;", "Vector3D sum = nothing;"));
  EXPECT_EQ(verdicts(report)["loop_subdivision"], "not compiled");
  EXPECT_EQ(report.points, report.max_points - 20.0);
}

TEST(AddedMembers, AreNamedWithTheirLineAndCostOnlyTheirUsers) {
  const Report report = grade_all(hand_in("added_members"));
  EXPECT_TRUE(
      has_note(report,
               "student_code.cpp:160 uses Vertex::timesSplit, a member that was added to "
               "the course's header (halfEdgeMesh.h, line 11)"));
  EXPECT_TRUE(
      has_note(report,
               "student_code.cpp:70 uses HalfedgeMesh::canFlip, a member that was added "
               "to the course's header (halfEdgeMesh.h, line 18)"));
  EXPECT_EQ(verdicts(report)["edge_flip"], "not compiled");
  EXPECT_EQ(verdicts(report)["edge_split"], "not compiled");
  expect_independent_exercises_passed(report);
}

}  // namespace
}  // namespace meshgrade
