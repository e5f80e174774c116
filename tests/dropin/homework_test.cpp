// Homework written for Berkeley's skeleton is graded as it was handed in. tests/dropin/homework
// holds some, in the styles of different years and authors; the broken ones are made from them
// by one edit.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include "grader/base/process.h"
#include "grader/base/safe_file.h"
#include "grader/grade/grading.h"
#include "grader/report/json_report.h"
#include "grader/report/terminal_report.h"
#include "grader/submission/function_extents.h"
#include "tests/dropin/course_project.h"
#include "tests/support/home_that_keeps.h"

namespace meshgrade {
namespace {

const std::filesystem::path kHomework =
    std::filesystem::path(MESHGRADE_SOURCE_DIR) / "tests" / "dropin" / "homework";

using Verdicts = std::map<std::string, std::string>;

Submission hand_in(const std::string& folder) {
  return find_submission(kHomework / folder, SubmissionRules());
}

void replace_in(Submission& submission, const std::string& part,
                const std::string& replacement) {
  std::string& text = submission.sources.at(0).text;
  const std::size_t at = text.find(part);
  if (at == std::string::npos) {
    ADD_FAILURE() << "the homework does not hold " << part;
    return;
  }
  text.replace(at, part.size(), replacement);
}

/// The homework `since_2020` with one part of it replaced.
Submission hand_in_with(const std::string& part, const std::string& replacement) {
  Submission submission = hand_in("since_2020");
  replace_in(submission, part, replacement);
  return submission;
}

Report grade_all(const Submission& submission) {
  return grade(read_assignment(standard_assignment()), submission, home_that_keeps(), {},
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

/// Cuts a member function out of a homework's file and puts it into its class, in the course's
/// own header.
void move_into_header(const std::filesystem::path& folder, const std::string& class_name,
                      const std::string& function, const std::string& header) {
  const std::string name = class_name + "::" + function;
  SourceFile file{"student_code.cpp", read_whole_file(folder / "student_code.cpp")};
  for (const FunctionExtent& found : find_functions(file.text)) {
    if (found.name != name) continue;
    std::string text = file.text.substr(found.begin, found.end - found.begin);
    text.replace(text.find(name), name.size(), function);
    write_file_safely(folder / header,
                      "#pragma once\n#include <vector>\nusing namespace std;\n"
                      "namespace CGL {\nclass " +
                          class_name + " {\n public:\n  " + text + "\n};\n}\n");
    file.text.erase(found.begin, found.end - found.begin);
    return write_file_safely(folder / file.name, file.text);
  }
  ADD_FAILURE() << "the homework does not define " << name;
}

class RightHomework : public testing::TestWithParam<std::string> {};

TEST_P(RightHomework, GetsEveryPoint) {
  const Report report = grade_all(hand_in(GetParam()));
  EXPECT_EQ(report.points, report.max_points);
  for (const auto& [exercise, verdict] : verdicts(report))
    EXPECT_EQ(verdict, "passed") << exercise;
}

INSTANTIATE_TEST_SUITE_P(Years, RightHomework,
                         testing::Values("of_2017", "of_2019", "since_2020", "whole_project",
                                         "added_members"),
                         folder_name);

class CourseHeaders : public testing::TestWithParam<std::string> {};

TEST_P(CourseHeaders, MayHoldGradedFunctions) {
  const ScratchFolder folder;
  for (const auto& file : std::filesystem::directory_iterator(kHomework / GetParam()))
    std::filesystem::copy(file.path(), folder.path());
  move_into_header(folder.path(), "Vertex", "normal", "halfEdgeMesh.h");
  move_into_header(folder.path(), "BezierPatch", "evaluate", "bezierPatch.h");
  const Submission submission = find_submission(folder.path(), SubmissionRules());
  EXPECT_EQ(submission.dialect, hand_in(GetParam()).dialect);
  const Report report = grade_all(submission);
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_TRUE(has_note(report, "graded stand in halfEdgeMesh.h"));
  EXPECT_TRUE(has_note(report, "graded stand in bezierPatch.h"));
}

INSTANTIATE_TEST_SUITE_P(Years, CourseHeaders,
                         testing::Values("of_2017", "of_2019", "since_2020"), folder_name);

TEST(Homework, BoundarySplitsEarnTheExtraCredit) {
  const Report report = grade_all(hand_in("of_2019"));
  EXPECT_EQ(report.extra_points, report.max_extra_points);
}

TEST(Homework, ThatDoesNothingForTheExtraCreditIsNotRunTwice) {
  const Report report = grade_all(hand_in("since_2020"));
  for (const ExerciseReport& exercise : report.exercises) {
    EXPECT_EQ(exercise.verdict, Verdict::kPassed) << exercise.name;
    EXPECT_TRUE(exercise.stand_ins.empty()) << exercise.name;
    for (const std::string& note : exercise.notes)
      EXPECT_EQ(note.find("again"), std::string::npos) << note;
  }
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

class Untouched : public testing::TestWithParam<std::string> {};

TEST_P(Untouched, IsNotImplementedInAllExercises) {
  const Report report = grade_all(hand_in(GetParam()));
  EXPECT_EQ(report.points, 0.0);
  for (const auto& [exercise, verdict] : verdicts(report))
    EXPECT_EQ(verdict, "not implemented") << exercise;
}

INSTANTIATE_TEST_SUITE_P(Years, Untouched,
                         testing::Values("untouched", "untouched_2016", "untouched_2017"),
                         folder_name);

/// What all findings of these exercises say, with the names of the cases and groups.
std::string all_words(const std::vector<ExerciseReport>& exercises) {
  std::string words;
  for (const ExerciseReport& exercise : exercises) {
    for (const GroupReport& group : exercise.groups)
      words += group.title + "\n";
    for (const CaseReport& c : exercise.cases) {
      words += c.title + " " + c.note + "\n";
      for (const FindingReport& f : c.findings)
        words += f.finding.meaning + " " + f.finding.element + " " + f.finding.look_at + "\n";
    }
  }
  return words;
}

TEST(Bezier, OfThePatchAsksForNetsOf4x4Only) {
  const Report report = grade_all(hand_in("one_point"));
  EXPECT_EQ(points(report, "bezier_curve"), 10.0);
  EXPECT_EQ(points(report, "bezier_patch"), 15.0);
}

TEST(Bezier, AmongTheCoursesOwnFilesIsThatOfTheStudent) {
  for (const char* homework : {"one_point", "of_2017"}) {
    const ScratchFolder folder;
    put_into_course_project(kHomework / homework, folder.path());
    const Report report = grade_all(find_submission(folder.path(), SubmissionRules()));
    EXPECT_EQ(points(report, "bezier_curve"), 10.0) << homework;
    EXPECT_EQ(points(report, "bezier_patch"), 15.0) << homework;
  }
}

TEST(Bezier, FindingsOf2017NameNoFunctionThatTheYearLacks) {
  Submission submission = hand_in("of_2017");
  std::string& text = submission.sources.at(0).text;
  const std::size_t at = text.find("BezierPatch::evaluate1D");
  ASSERT_NE(at, std::string::npos);
  text.insert(text.find('{', at) + 1, " if (t > 0) return points[0];\n");
  const Report report = grade_all(submission);
  EXPECT_EQ(verdicts(report)["bezier_patch"], "failed");
  EXPECT_EQ(all_words(report.exercises).find("BezierPatch::evaluateStep"), std::string::npos);
  for (const ExerciseReport& exercise : report.exercises) {
    if (exercise.name != "bezier_patch") continue;
    EXPECT_EQ(all_words({exercise}).find("evaluateStep"), std::string::npos);
  }
}

/// The points for a right patch whose evaluate1D gives nonsense where `counted` is not 4.
double points_of_who_counts_on_four(const std::string& counted) {
  Submission submission = hand_in("of_2017");
  std::string& text = submission.sources.at(0).text;
  const std::size_t at = text.find("BezierPatch::evaluate1D");
  text.insert(text.find('{', at) + 1, " if (" + counted + " != 4) return Vector3D(9);\n");
  return points(grade_all(submission), "bezier_patch");
}

TEST(Bezier, MayCountOnFourPoints) {
  EXPECT_EQ(points_of_who_counts_on_four("points.size()"), 15.0);
}

TEST(Bezier, MayCountOnFourRows) {
  EXPECT_EQ(points_of_who_counts_on_four("controlPoints.size()"), 15.0);
}

TEST(Bezier, MayCountOnNoFivePoints) {
  EXPECT_LT(points_of_who_counts_on_four("1 + points.size()"), 15.0);
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

// The class names of 2017 are macros: what is wrong with one is still told of the student's
// line.
TEST(BrokenFunction, MayBeBrokenInItsHeadIn2017) {
  Submission submission = hand_in("of_2017");
  replace_in(submission, "Vector3D BezierPatch::evaluate(double u, double v) const",
             "Vector3D BezierPatch::evaluate(float u, float v) const");
  const Report report = grade_all(submission);
  EXPECT_LT(points(report, "bezier_patch"), 15.0);
  EXPECT_EQ(report.points, report.max_points - 15.0 + points(report, "bezier_patch"));
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

TEST(AddedMembers, MayBeToldFromTheirUse) {
  Submission submission = hand_in("added_members");
  submission.course_headers.clear();
  const Report report = grade_all(submission);
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_TRUE(has_note(report, "uses Vertex::timesSplit, which no header that was handed in"));
  EXPECT_TRUE(has_note(report, "defines HalfedgeMesh::canFlip, which no header"));
}

/// The homework `since_2020` that marks edges in a member of its own, declared like this.
Submission hand_in_marking(const std::string& declaration, const std::string& behind = "") {
  Submission submission =
      hand_in_with("VertexIter m = newVertex();", "VertexIter m = newVertex(); m->mine += 1;");
  submission.course_headers = {{"halfEdgeMesh.h", "class Vertex {\n public:\n  Vector3D " +
                                                      ("position;\n  " + declaration) +
                                                      "\n};\n" + behind}};
  return submission;
}

TEST(AddedMembers, MayBeOfAnyTypeThatTheGraderKnows) {
  const Report report = grade_all(
      hand_in_marking("float mine, yours; double half = 0.5; static constexpr int k = 3;\n"
                      "  std::vector<EdgeIter> near; map<VertexIter, double> far; Matrix3x3 "
                      "turn; Color paint;\n"
                      "  enum Kind { A, B }; Kind kind; long row[3];\n"
                      "  bool any() const { return yours + half + k + near.size() + far.size() "
                      "+ turn.norm() +\n"
                      "                            paint.r + kind + row[0] > 0; }\n"
                      "  void touch() { if (any()) mine = 1; }"));
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_TRUE(has_note(report, "halfEdgeMesh.h holds members of your own"));
}

TEST(AddedMembers, BeginAtZeroAndAreCopiedWithTheMesh) {
  Submission submission = hand_in_marking("int mine; HalfedgeIter out;");
  std::string& text = submission.sources.at(0).text;
  const std::string mark = "VertexIter m = newVertex(); m->mine += 1;";
  text.replace(text.find(mark), mark.size(),
               "VertexIter m = newVertex(); if (m->mine != 0) abort(); m->mine = 7;\n"
               "HalfedgeMesh other(*this); VertexIter last = --other.verticesEnd();\n"
               "if (last->mine != 7) abort(); last->mine = 8; if (m->mine != 7) abort();");
  const Report report = grade_all(submission);
  EXPECT_EQ(verdicts(report)["edge_split"], "passed");
}

TEST(AddedMembers, CannotBeOfATypeThatTheGraderLacks) {
  const Report report = grade_all(hand_in_marking("GLWindow* mine;"));
  EXPECT_EQ(verdicts(report)["edge_split"], "not judged");
  EXPECT_EQ(verdicts(report)["edge_flip"], "passed");
  EXPECT_EQ(verdicts(report)["loop_subdivision"], "not judged");
  EXPECT_EQ(report.points_not_judged(), 40.0);
  EXPECT_NE(to_terminal(report, {})
                .find("40 of the missing points were not judged (edge_split, loop"),
            std::string::npos);
  EXPECT_NE(to_json(report).find("\"points_not_judged\": 40"), std::string::npos);
  EXPECT_TRUE(has_note(report, "halfEdgeMesh.h:4: Vertex::mine cannot be taken over"));
  EXPECT_TRUE(has_note(report,
                       "uses Vertex::mine, a member that was added to the course's "
                       "header (halfEdgeMesh.h, line 4)"));
  expect_independent_exercises_passed(report);
}

TEST(AddedMembers, MayBeOfCurvesAndPatches) {
  Submission submission = hand_in_with("return evaluate1D(col, v);", "return last(col, v);");
  replace_in(submission, "std::vector<Vector2D> res;",
             "std::vector<Vector2D> res; calls += 1;");
  submission.course_headers = {
      {"bezierCurve.h", "class BezierCurve {\n  int calls;\n};\n"},
      {"bezierPatch.h",
       "class BezierPatch {\n  Vector3D last(std::vector<Vector3D> points, double t) const {\n"
       "    return evaluate1D(points, t);\n  }\n};\n"}};
  const Report report = grade_all(submission);
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_TRUE(has_note(report, "bezierCurve.h holds members of your own"));
  EXPECT_TRUE(has_note(report, "BezierPatch::last"));
}

TEST(AddedMembers, OfCurvesAndPatchesMayBeToldFromTheirDefinition) {
  const std::string declared_nowhere = ", which no header that was handed in declares";
  Submission submission =
      hand_in_with("return evaluate1D(col, v);", "return evaluate2D(col, v);");
  replace_in(submission, "Vector3D BezierPatch::evaluate(double",
             "Vector3D BezierPatch::evaluate2D(std::vector<Vector3D> points, double t) const\n"
             "  {\n    return evaluate1D(points, t);\n  }\n\n"
             "  Vector3D BezierPatch::evaluate(double");
  Report report = grade_all(submission);
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_TRUE(has_note(report, "defines BezierPatch::evaluate2D" + declared_nowhere));

  submission = hand_in("of_2017");
  replace_in(submission, "(1 - t) * last[i] + t * last[i + 1]", "mix(last[i], last[i + 1])");
  replace_in(submission, "void BezierCurve::evaluateStep()",
             "Vector2D BezierCurve::mix(Vector2D a, Vector2D b) const\n"
             "  {\n    return (1 - t) * a + t * b;\n  }\n\n  void BezierCurve::evaluateStep()");
  report = grade_all(submission);
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_TRUE(has_note(report, "defines BezierCurve::mix" + declared_nowhere));
}

TEST(AddedMembers, OfEdgeRecordsBeginAsTheirHeaderSays) {
  Submission submission = hand_in_with("VertexIter m = newVertex();",
                                       "VertexIter m = newVertex();\n"
                                       "if (e0->record.cost != 2) abort();\n"
                                       "e0->record.near.push_back(e0);\n"
                                       "if (e0->record.near.back() != e0) abort();\n");
  submission.course_headers = {
      {"halfEdgeMesh.h",
       "class EdgeRecord {\n public:\n  double cost = 2;\n  std::vector<EdgeIter> near;\n"
       "  double score;\n};\n"}};
  const Report report = grade_all(submission);
  EXPECT_EQ(report.points, report.max_points);
}

TEST(AddedMembers, WithASlipOfThePenDoNotCompile) {
  const Report report = grade_all(hand_in_with("VertexIter m = newVertex();",
                                               "VertexIter m = newVertex(); m->isnew = true;"));
  EXPECT_EQ(verdicts(report)["edge_split"], "not compiled");
}

TEST(AddedMembers, QuadricIsThereWhereItIsUsed) {
  const Report report = grade_all(
      hand_in_with("VertexIter m = newVertex();",
                   "VertexIter m = newVertex(); m->quadric += Matrix4x4::identity();\n"
                   "if (m->quadric.norm() != 2) abort();"));
  EXPECT_EQ(verdicts(report)["edge_split"], "passed");
}

TEST(AddedMembers, FunctionsMayBeDefinedInTheHeader) {
  Submission submission = hand_in_marking(
      "int mine;\n  void count() { mine += step(); }\n  int step() const;",
      "inline int Vertex::step() const { return one() + halfedge()->face()->isBoundary(); }\n");
  submission.course_headers[0].text.insert(0, "static int one() { return 1; }\n");
  std::string& text = submission.sources.at(0).text;
  text.replace(text.find("m->mine += 1"), 12, "m->count()  ");
  // step() is called before m has a half-edge: only that it is called is of interest here.
  const Report report = grade_all(submission);
  EXPECT_NE(verdicts(report)["edge_split"], "not compiled");
  EXPECT_NE(verdicts(report)["edge_split"], "not judged");
  EXPECT_TRUE(has_note(report, "Vertex::step"));
}

}  // namespace
}  // namespace meshgrade
