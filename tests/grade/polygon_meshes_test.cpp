// The second assignment, from source to report: wrong solutions that are the reference but for
// a line, and right ones that do it in another way.

#include <gtest/gtest.h>

#include "grader/base/errors.h"
#include "tests/grade/graded_change.h"

namespace meshgrade {
namespace {

class WrongOperation : public testing::TestWithParam<Change> {};

TEST_P(WrongOperation, LosesPointsAndIsToldWhy) {
  const Change& change = GetParam();
  const ExerciseReport report =
      grade_one(change.exercise, altered(path_of(change.exercise), change.was, change.becomes));
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_LT(report.points, report.max_points);
  const Finding& finding = first_finding(report);
  EXPECT_EQ(finding.rule, change.rule);
  EXPECT_FALSE(finding.expected.empty());
  EXPECT_FALSE(finding.actual.empty());
  EXPECT_FALSE(finding.look_at.empty());
}

const Change kWrong[] = {
    {"AlwaysRefuses", "edge_collapse", "const HalfedgeIter h = e->halfedge();",
     "return std::nullopt; const HalfedgeIter h = e->halfedge();", "refused"},
    {"NeverRefuses", "edge_dissolve",
     "if (t->isBoundary() ? touchesBoundaryElsewhere(h) : shareMoreThanTheEdge(h))\n"
     "    return std::nullopt;",
     "", "not-refused"},
    {"RefusesAfterAChange", "edge_flip_polygon", "if (e->isBoundary()) return std::nullopt;",
     "if (e->isBoundary()) { newVertex(); return std::nullopt; }", "refused-unchanged"},
    {"DoesNothing", "vertex_inset", "std::vector<HalfedgeIter> sides;",
     "if (f->degree() == 4) return f->halfedge()->vertex(); std::vector<HalfedgeIter> sides;",
     "nothing-done"},
    {"TurnsClockwise", "edge_flip_polygon",
     "const HalfedgeIter h = e->halfedge();  // a to b, in f",
     "const HalfedgeIter h = previousOf(e->halfedge());", "surface"},
    {"CutsTheOutside", "edge_split_polygon", "if (!t->isBoundary()) cutCorner(*this, t, ma);",
     "cutCorner(*this, t, ma);", "counts"},
    {"IsNotInTheMiddle", "edge_collapse", "a->position = 0.5 * (a->position + b->position);",
     "", "new-position"},
    {"ReturnsTheOldCorner", "vertex_inset", "return m;", "return sides[0]->vertex();",
     "returned"},
    {"AnchorsOnACut", "edge_split_polygon", "if (!t->isBoundary()) cutCorner(*this, t, ma);",
     "if (!t->isBoundary()) cutCorner(*this, t, ma);\n  m->halfedge() = h->next();",
     "along-edge"},
    {"LeavesAnAnchor", "edge_dissolve", "h->vertex()->halfedge() = t->next();", "",
     "live-pointer"},
    {"CopiesTheCornersElsewhere", "face_extrude",
     "corners[i]->position = sides[i]->vertex()->position;",
     "corners[i]->position = 0.9 * sides[i]->vertex()->position;", "new-position"},
    {"LeavesTwoCorners", "face_collapse",
     "if (around(face->halfedge()).size() == 2) closeUp(*this, face->halfedge());", "",
     "counts"},
    {"TakesTheFirstCorner", "face_collapse",
     "left->position = sum / static_cast<double>(sides.size());", "", "new-position"},
    {"CreatesBeforeItRefuses", "face_collapse",
     "if (!doesBoundaryAllow(sides) || !doNeighboursAllow(f, sides)) return std::nullopt;",
     "const VertexIter m = newVertex();\n"
     "  if (!doesBoundaryAllow(sides) || !doNeighboursAllow(f, sides)) return std::nullopt;\n"
     "  deleteVertex(m);",
     "refused-unchanged"},
    {"BevelsTwoEdges", "vertex_bevel", "if (n < 3) return std::nullopt;", "", "not-refused"},
    {"LeavesTheVertex", "vertex_bevel", "deleteVertex(v);", "", "counts"},
    {"NamesTheEdgeThatIsGone", "edge_bevel", "around[i]->halfedge() = outer[i];", "",
     "live-pointer"},
    {"PutsAllInTheMiddle", "edge_bevel", "end->position = spoke->vertex()->position;",
     "end->position = 0.5 * (a->position + b->position);", "new-position"},
    {"DoesNotSeeACorner", "face_remove",
     "if (sides[i]->vertex()->isBoundary() && !is_side) return false;", "", "not-refused"},
    {"ReturnsAnotherLoop", "face_remove", "return left;",
     "for (FaceIter b = boundariesBegin(); b != boundariesEnd(); ++b) {\n"
     "    if (b != left) return b;\n  }\n  return left;",
     "returned"},
    {"KeepsOneLoop", "edge_weld", "if (old_loops.count(begin->face()) == 0) continue;",
     "if (begin != begins.front()) continue;", "counts"},
    {"RefusesToZip", "edge_weld",
     "if (e == f || !e->isBoundary() || !f->isBoundary()) return std::nullopt;",
     "if (e == f || !e->isBoundary() || !f->isBoundary()) return std::nullopt;\n"
     "  if (outsideOf(e)->face() == outsideOf(f)->face()) return std::nullopt;",
     "refused"},
    {"WeldsTurnedOver", "edge_weld", "const HalfedgeIter g = outsideOf(f);",
     "const HalfedgeIter g = outsideOf(f)->twin();", "refused"},
    {"MovesAnOldVertex", "vertex_dissolve", "const FaceIter face = newFace();",
     "const FaceIter face = newFace();\n  sides[0]->vertex()->position += Vector3D(0, 0, 1);",
     "position"},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, WrongOperation, testing::ValuesIn(kWrong),
                         [](const auto& tested) { return std::string(tested.param.name); });

class RightOperation : public testing::TestWithParam<Change> {};

TEST_P(RightOperation, HasEveryPointDoneInAnotherWay) {
  const Change& change = GetParam();
  const ExerciseReport report =
      grade_one(change.exercise, altered(path_of(change.exercise), change.was, change.becomes));
  EXPECT_EQ(report.verdict, Verdict::kPassed) << first_finding(report).actual;
  EXPECT_EQ(report.points, report.max_points);
}

const Change kRight[] = {
    {"KeepsTheOtherEnd", "edge_collapse", "const HalfedgeIter h = e->halfedge();",
     "const HalfedgeIter h = e->halfedge()->twin();", ""},
    {"DoesWhatIsDegenerate", "edge_collapse",
     "if (neighbours_of_b.count(neighbour) != 0 && apexes.count(neighbour) == 0) return true;",
     "", ""},
    {"BeginsOnTheOtherSide", "edge_flip_polygon",
     "const HalfedgeIter h = e->halfedge();  // a to b, in f",
     "const HalfedgeIter h = e->halfedge()->twin();", ""},
    {"ComputesInFloat", "face_collapse", "sum += side->vertex()->position;",
     "for (int i = 0; i < 3; ++i) sum[i] = static_cast<float>(\n"
     "        static_cast<float>(sum[i]) + "
     "static_cast<float>(side->vertex()->position[i]));",
     ""},
    {"BeginsAtAnotherCorner", "face_collapse", "around(f->halfedge());",
     "around(f->halfedge()->next());", ""},
    {"KeepsTheOtherEdge", "edge_weld", "const HalfedgeIter h = outsideOf(e);",
     "std::swap(e, f);\n  const HalfedgeIter h = outsideOf(e);", ""},
    {"BevelsFromTheOtherEnd", "edge_bevel", "const HalfedgeIter h = e->halfedge();",
     "const HalfedgeIter h = e->halfedge()->twin();", ""},
    {"RefusesALoneCorner", "vertex_dissolve",
     "if (!isFace(sides, boundary)) return std::nullopt;",
     "if (!isFace(sides, boundary) || (boundary && spokes.size() == 2)) return std::nullopt;",
     ""},
};

INSTANTIATE_TEST_SUITE_P(Ways, RightOperation, testing::ValuesIn(kRight),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(RefusingAlways, EarnsNothingForWhatIsRefused) {
  const ExerciseReport report =
      grade_one("edge_collapse",
                altered(path_of("edge_collapse"), "const HalfedgeIter h = e->halfedge();",
                        "return std::nullopt; const HalfedgeIter h = e->halfedge();"));
  EXPECT_EQ(report.points, 0.0);
}

TEST(ALargeMesh, IsNotWalkedOver) {
  const ExerciseReport report = grade_one(
      "vertex_inset", altered(path_of("vertex_inset"), "std::vector<HalfedgeIter> sides;",
                              "for (auto v = verticesBegin(); v != verticesEnd(); ++v) "
                              "v->isNew = false;\n  std::vector<HalfedgeIter> sides;"));
  EXPECT_EQ(report.verdict, Verdict::kOutOfSteps);
  EXPECT_LT(report.points, report.max_points);
}

TEST(NamedAssignment, IsRecognisedByTheFunctionsThatAreDefined) {
  const std::filesystem::path reference = find_home().reference;
  EXPECT_EQ(load_assignment_of("", reference / "polygon_meshes").folder, "polygon_meshes");
  EXPECT_EQ(load_assignment_of("", reference).folder, "");
  EXPECT_EQ(load_assignment_of("", reference / "nothing").folder, "");
  EXPECT_THROW(load_assignment("polygons"), UserError);
}

}  // namespace
}  // namespace meshgrade
