// Cases that fail are made smaller until nothing can be left out.

#include "grader/grade/shrinking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grader/cases/case_list.h"
#include "grader/cases/mesh_input.h"
#include "grader/commands/context.h"
#include "grader/grade/grading.h"
#include "grader/judge/judge.h"
#include "tests/grade/spoiled_reference.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;
using testing::Le;
using testing::SizeIs;

class Shrinking : public testing::Test {
 protected:
  /// The first case that fails, as it is shown, of a submission with this file.
  const CaseReport& first_failure_of(const std::string& exercise,
                                     std::vector<SourceFile> files) {
    submission_.name = "test";
    submission_.sources = std::move(files);
    report_ = grade(assignment_, submission_, find_home(), {exercise}, [](const auto&) {});
    for (const CaseReport& c : report_.exercises.at(0).cases) {
      if (c.verdict != Verdict::kPassed) return c;
    }
    ADD_FAILURE() << "everything passes";
    return report_.exercises.at(0).cases.at(0);
  }

  /// The operations of the case as it is shown.
  OperationsInput shown(const CaseReport& report) const {
    const Build build = build_submission(submission_, find_home(), assignment_.limits);
    const Case asked = find_case(assignment_, find_home().meshes, report.id);
    const Case c = shown_case(assignment_, submission_, find_home(), build, asked);
    EXPECT_EQ(c.title, report.title) << "the report and a replay show the same";
    return from_wire<OperationsInput>(c.input);
  }

  Assignment assignment_ = read_assignment(standard_assignment());
  Submission submission_;
  Report report_;
};

TEST_F(Shrinking, FindsTheOneFlipThatGoesWrong) {
  // Only where three flips at one vertex came before: no case of a single flip shows it.
  const CaseReport& failed = first_failure_of(
      "edge_flip", {spoiled("edge_flip.cpp", "return e0;",
                            "if (a->degree() >= 9) f->halfedge() = f->halfedge()->twin();\n")});
  EXPECT_THAT(failed.shrunk_from, HasSubstr("random flips of "));
  const OperationsInput small = shown(failed);
  EXPECT_THAT(small.operations, SizeIs(Le(4U))) << failed.title;
  for (const FindingReport& finding : failed.findings)
    EXPECT_THAT(finding.finding.rule, testing::Not(testing::IsEmpty()));
}

TEST_F(Shrinking, LeavesOutSplitsAndRenumbersWhatFollows) {
  const CaseReport& failed = first_failure_of(
      "edge_split",
      {reference_file("edge_flip.cpp"),
       spoiled("edge_split.cpp", "return m;",
               "if (nFaces() > 30 && m->degree() == 4 && h->vertex()->degree() >= 8)\n"
               "    m->position.x += 1;\n")});
  EXPECT_THAT(failed.shrunk_from, HasSubstr("random splits"));
  const OperationsInput small = shown(failed);
  EXPECT_THAT(small.operations, SizeIs(Le(4U))) << failed.title;
}

TEST_F(Shrinking, FindsFewerLevels) {
  // What the first call leaves behind spoils the second one.
  SourceFile file = reference_file("loop_subdivision.cpp");
  for (const std::string reset : {"v->isNew = false;", "e->isNew = false;"})
    file.text.replace(file.text.find(reset), reset.size(), "");
  const CaseReport& failed = first_failure_of(
      "loop_subdivision",
      {reference_file("edge_flip.cpp"), reference_file("edge_split.cpp"), file});
  EXPECT_EQ(failed.title, "2 levels on tetrahedron.obj");
  EXPECT_EQ(failed.shrunk_from, "4 levels on tetrahedron.obj");
}

TEST_F(Shrinking, FindsFewerPoints) {
  SourceFile file = reference_file("bezier_curve.cpp");
  const std::size_t body = file.text.find('{', file.text.find("BezierCurve::evaluateStep"));
  file.text.insert(body + 1, " if (points.size() > 10) return points;\n");
  const CaseReport& failed = first_failure_of("bezier_curve", {file});
  EXPECT_EQ(failed.shrunk_from, "") << "the smallest case is asked first: " << failed.title;
  EXPECT_THAT(failed.title, HasSubstr("one step with 11 points"));
}

TEST_F(Shrinking, FindsASmallerNet) {
  SourceFile file = reference_file("bezier_patch.cpp");
  const std::size_t body = file.text.find('{', file.text.find("BezierPatch::evaluate("));
  file.text.insert(body + 1, " if (controlPoints.size() > 4) return Vector3D();\n");
  const CaseReport& failed = first_failure_of("bezier_patch", {file});
  EXPECT_THAT(failed.title, HasSubstr("(5 rows of 2) at 1 place"));
  EXPECT_THAT(failed.shrunk_from, HasSubstr("5 rows of "));
}

TEST_F(Shrinking, KeepsACaseThatOnlyFailsAsItIs) {
  const CaseReport& failed = first_failure_of(
      "edge_flip", {spoiled("edge_flip.cpp", "return e0;", "return EdgeIter();")});
  EXPECT_EQ(failed.shrunk_from, "") << "the first case is as small as it gets";
}

TEST(SmallerCases, AreLegalAndSmallerForEveryExercise) {
  const Assignment assignment = read_assignment(standard_assignment());
  const auto meshes = find_home().meshes;
  for (const ExerciseRubric& rubric : assignment.exercises) {
    std::size_t made = 0;
    for (const Case& c : make_cases(assignment, rubric, meshes)) {
      for (const Case& smaller : make_smaller_cases(assignment, rubric, meshes, c)) {
        ++made;
        EXPECT_EQ(smaller.id(), c.id());
        EXPECT_LE(smaller.input.size(), c.input.size()) << smaller.title;
        EXPECT_NE(smaller.input, c.input) << smaller.title;
      }
    }
    EXPECT_GT(made, 0U) << rubric.name;
  }
}

}  // namespace
}  // namespace meshgrade
