// The exercises about the whole mesh, from source to report: wrong solutions that are the
// reference but for a line, what each probably comes from, and right ones done in another way.

#include <gtest/gtest.h>

#include <set>

#include "grader/judge/refinement_rules.h"
#include "tests/grade/graded_change.h"

namespace meshgrade {
namespace {

SourceFile changed(const Change& change) {
  return altered(path_of(change.exercise), change.was, change.becomes);
}

class WrongOnTheWhole : public testing::TestWithParam<Change> {};

TEST_P(WrongOnTheWhole, LosesPointsAndIsToldWhy) {
  const Change& change = GetParam();
  const ExerciseReport report = grade_one(change.exercise, changed(change));
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_LT(report.points, report.max_points);
  const Finding& finding = first_finding(report);
  EXPECT_EQ(finding.rule, change.rule);
  EXPECT_FALSE(finding.meaning.empty());
  EXPECT_FALSE(finding.expected.empty());
  EXPECT_FALSE(finding.actual.empty());
  EXPECT_FALSE(finding.look_at.empty());
}

const Change kWrongOnTheWhole[] = {
    {"LeavesPentagonsAlone", "triangulation", "const Size n = sides.size();",
     "const Size n = sides.size(); if (n > 4) continue;", "triangles"},
    {"CutsOnce", "triangulation", "i + 2 < n; ++i", "i < 2 && n > 3; ++i", "triangles"},
    {"MakesAFaceTooMany", "triangulation", "const Size n = sides.size();",
     "const Size n = sides.size(); if (n > 3) newFace();", "counts"},
    {"LeavesAStaleAnchor", "triangulation", "f->halfedge() = leaving;", "", "anchor"},
    {"LinksATriangleClockwise", "triangulation",
     "back->setNeighbors(leaving, forth, sides[i + 1]->vertex()",
     "back->setNeighbors(leaving, forth, sides[0]->vertex()", "twin-opposite"},
    {"LeavesTheFaceOfACorner", "triangulation", "sides[i]->face() = triangle;", "",
     "next-face"},
    {"MovesAVertex", "triangulation", "std::vector<FaceIter> old_faces;",
     "verticesBegin()->position *= 2.0; std::vector<FaceIter> old_faces;", "position"},
    {"SwapsTwoOldEdges", "triangulation", "std::vector<FaceIter> old_faces;",
     "EdgeIter a = edgesBegin(); EdgeIter b = a; ++b;\n"
     "  HalfedgeIter x = a->halfedge(); HalfedgeIter y = b->halfedge();\n"
     "  x->edge() = x->twin()->edge() = b; y->edge() = y->twin()->edge() = a;\n"
     "  a->halfedge() = y; b->halfedge() = x;\n  std::vector<FaceIter> old_faces;",
     "identity"},
    {"ForgetsAnEdge", "linear_subdivision", "EdgeIter e = edgesBegin()",
     "EdgeIter e = ++edgesBegin()", "missing-position"},
    {"FillsNoFaces", "linear_subdivision", "FaceIter f = facesBegin()",
     "FaceIter f = facesEnd()", "missing-position"},
    {"AsksForBoundaryLoops", "linear_subdivision", "return refined;",
     "for (FaceIter b = boundariesBegin(); b != boundariesEnd(); ++b) refined.faces[b] = "
     "Vector3D();\n  return refined;",
     "boundary-position"},
    {"AsksForAnUnsetEdge", "linear_subdivision", "return refined;",
     "refined.edges[EdgeIter()] = Vector3D();\n  return refined;", "foreign-position"},
    {"GivesElementsOfACopy", "linear_subdivision", "return refined;",
     "static HalfedgeMesh copy; copy = *this; refined.vertices[copy.verticesBegin()] = "
     "Vector3D();\n  return refined;",
     "foreign-position"},
    {"MovesTheVertices", "linear_subdivision", "return refined;",
     "verticesBegin()->position *= 2.0;\n  return refined;", "mesh-changed"},
    {"TurnsAnAnchor", "linear_subdivision", "return refined;",
     "facesBegin()->halfedge() = facesBegin()->halfedge()->next();\n  return refined;",
     "mesh-changed"},
    {"MakesAVertex", "linear_subdivision", "return refined;", "newVertex();\n  return refined;",
     "mesh-changed"},
    {"DividesByZero", "linear_subdivision", "static_cast<double>(f->degree());", "0.0;",
     "finite"},
    {"HasOtherWeights", "catmull_clark", "(Q + 2.0 * R + (n - 3.0) * S) / n",
     "0.9 * S + 0.1 * R", "position"},
    {"SmoothsTheBoundaryAtOneCallOnly", "catmull_clark", "RefinedPositions refined;",
     "RefinedPositions refined; static int calls = 0; ++calls;\n"
     "  if (calls % 3 == 0) refined.vertices[VertexIter()] = Vector3D();",
     "foreign-position"},
    {"TrustsTheAnchorOnABoundary", "catmull_clark", "const bool boundary = v->isBoundary();",
     "const bool boundary = v->halfedge()->isBoundary();", "position"},
    {"RefusesTriangles", "loop_refinement", "return true;", "return false;", "refused"},
    {"RefusesNothing", "loop_refinement", "if (f->degree() != 3) return false;", "",
     "not-refused"},
    {"SaysThatItIsDone", "loop_refinement", "if (f->degree() != 3) return false;",
     "if (f->degree() != 3) return true;", "not-refused"},
    {"RefusesAfterAChange", "loop_refinement", "if (f->degree() != 3) return false;",
     "if (f->degree() != 3) { newVertex(); return false; }", "refused-unchanged"},
    {"LeavesAnEdgeWithoutAnchor", "loop_refinement", "behind->halfedge() = mb;", "",
     "live-pointer"},
    {"CutsNoFaces", "loop_refinement", "cutIntoFour(*this, f);", ";", "face-loop"},
    {"TakesOtherWeights", "loop_refinement", "0.375 * ends + 0.125 *", "0.25 * ends + 0.25 *",
     "position"},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, WrongOnTheWhole, testing::ValuesIn(kWrongOnTheWhole),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// `rule` is the cause that is named.
class Misunderstood : public testing::TestWithParam<Change> {};

TEST_P(Misunderstood, IsNamedAlone) {
  const Change& change = GetParam();
  const ExerciseReport report = grade_one(change.exercise, changed(change));
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_EQ(causes_of(report), std::set<std::string>{change.rule});
  EXPECT_EQ(first_finding(report).rule, "position") << first_finding(report).actual;
}

constexpr const char* kInnerRule = "(Q + 2.0 * R + (n - 3.0) * S) / n";
constexpr const char* kBoundaryRule = "0.75 * S + 0.125 * along";
constexpr const char* kVertexRule =
    "boundary ? 0.75 * S + 0.125 * along : (Q + 2.0 * R + (n - 3.0) * S) / n";

const Change kMisunderstood[] = {
    {"FaceZero", "linear_subdivision", "sum / static_cast<double>(f->degree())",
     "1 / static_cast<int>(f->degree()) * sum", "face-zero"},
    {"FaceSum", "linear_subdivision", "sum / static_cast<double>(f->degree())", "sum",
     "face-sum"},
    {"FaceByFour", "linear_subdivision", "static_cast<double>(f->degree())", "4.0",
     "face-fixed-number"},
    {"FaceByThree", "linear_subdivision", "static_cast<double>(f->degree())", "3.0",
     "face-fixed-number"},
    {"FaceCornerLeftOut", "linear_subdivision",
     "do {\n      sum += h->vertex()->position;\n      h = h->next();\n    } while (h != "
     "f->halfedge());",
     "for (h = h->next(); h != f->halfedge(); h = h->next()) sum += h->vertex()->position;",
     "face-corner-left-out"},
    {"EdgeZero", "linear_subdivision", "0.5 * (h->", "1 / 2 * (h->", "edge-zero"},
    {"EdgeSum", "linear_subdivision", "0.5 * (h->", "1.0 * (h->", "edge-sum"},
    {"EdgeAtTheStart", "linear_subdivision", "h->twin()->vertex()->position",
     "h->twin()->next()->vertex()->position", "edge-at-an-end"},
    {"EdgeAtTheEnd", "linear_subdivision", "(h->vertex()->position",
     "(h->twin()->vertex()->position", "edge-at-an-end"},
    {"VertexZero", "linear_subdivision", "refined.vertices[v] = v->position",
     "refined.vertices[v] = v->newPosition", "vertex-zero"},
    {"FacesOfCatmullClark", "catmull_clark", "sum / static_cast<double>(f->degree())", "sum",
     "face-sum"},
    {"EdgeMidpoints", "catmull_clark", "0.25 * (ends + beside)", "0.5 * ends + 0.0 * beside",
     "edge-midpoints"},
    {"EdgeWholeNumbers", "catmull_clark", "0.25 * (ends", "1 / 4 * (ends", "edge-zero"},
    {"EdgeNotDivided", "catmull_clark", "0.25 * (ends", "1.0 * (ends", "edge-not-divided"},
    {"EdgeMiddleAndFaces", "catmull_clark", "0.25 * (ends + beside)",
     "(0.5 * ends + beside) / 3.0", "edge-middle-and-faces"},
    {"EdgeSameFaceTwice", "catmull_clark", "refined.faces[h->twin()->face()]",
     "refined.faces[h->face()]", "edge-same-face-twice"},
    {"EdgeBoundarySum", "catmull_clark", "refined.edges[e] = 0.5 * ends",
     "refined.edges[e] = ends", "edge-sum"},
    {"EdgeBoundaryByThree", "catmull_clark", "refined.edges[e] = 0.5 * ends",
     "refined.edges[e] = (ends + refined.faces[(h->isBoundary() ? h->twin() : h)->face()]) / "
     "3.0",
     "edge-boundary-like-inside"},
    {"EdgeBoundaryByFour", "catmull_clark", "refined.edges[e] = 0.5 * ends",
     "refined.edges[e] = (ends + refined.faces[(h->isBoundary() ? h->twin() : h)->face()]) / "
     "4.0",
     "edge-boundary-like-inside"},
    {"VertexKept", "catmull_clark", kVertexRule, "S", "vertex-kept"},
    {"SmoothVertexZero", "catmull_clark", kVertexRule, "v->newPosition", "vertex-zero"},
    {"RFromEdgePoints", "catmull_clark", "middles += 0.5 * (S + neighbour)",
     "middles += refined.edges[h->edge()]", "r-from-edge-points"},
    {"RFromNeighbours", "catmull_clark", "middles += 0.5 * (S + neighbour)",
     "middles += neighbour", "r-from-neighbours"},
    {"QFromTheVertex", "catmull_clark", "const Vector3D Q = faces / n", "const Vector3D Q = S",
     "q-from-the-vertex"},
    {"QIsASum", "catmull_clark", "const Vector3D Q = faces / n", "const Vector3D Q = faces",
     "sums-for-means"},
    {"RIsASum", "catmull_clark", "const Vector3D R = middles / n", "const Vector3D R = middles",
     "sums-for-means"},
    {"OwnWeightZero", "catmull_clark", kInnerRule, "(Q + 2.0 * R) / n", "own-weight-zero"},
    {"RWeightZero", "catmull_clark", kInnerRule, "(Q + (n - 3.0) * S) / n", "r-weight-zero"},
    {"NotDivided", "catmull_clark", kInnerRule, "Q + 2.0 * R + (n - 3.0) * S",
     "not-divided-by-n"},
    {"DividedByFour", "catmull_clark", kInnerRule, "(Q + 2.0 * R + (n - 3.0) * S) / 4.0",
     "four-for-n"},
    {"ValenceFour", "catmull_clark", kInnerRule, "(Q + 2.0 * R + S) / 4.0", "four-for-n"},
    {"BoundaryLikeInside", "catmull_clark", kVertexRule, kInnerRule, "boundary-like-inside"},
    {"BoundaryVertexKept", "catmull_clark", kBoundaryRule, "S", "boundary-vertex-kept"},
    {"BoundaryQuarter", "catmull_clark", kBoundaryRule, "0.75 * S + 0.25 * along",
     "boundary-quarter"},
    {"BoundaryHalfAndQuarter", "catmull_clark", kBoundaryRule, "0.5 * S + 0.25 * along",
     "boundary-quarter"},
    {"BoundaryEighthZero", "catmull_clark", kBoundaryRule, "0.75 * S + 1 / 8 * along",
     "boundary-whole-numbers"},
    {"BoundaryThreeQuartersZero", "catmull_clark", kBoundaryRule, "3 / 4 * S + 0.125 * along",
     "boundary-whole-numbers"},
    {"BoundaryVerticesCounted", "catmull_clark", "if (h->edge()->isBoundary())",
     "if (h->twin()->vertex()->isBoundary())", "boundary-vertices-counted"},
    {"BoundaryEdgePoints", "catmull_clark", "along += neighbour",
     "along += refined.edges[h->edge()]", "boundary-edge-points"},
};

INSTANTIATE_TEST_SUITE_P(Causes, Misunderstood, testing::ValuesIn(kMisunderstood),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// The two ways in which degree(), which counts faces, is taken for the number of edges.
TEST(MisunderstoodRules, FacesAreCountedForEdgesOnABoundary) {
  for (const char* means :
       {"const Vector3D R = middles / n", "const Vector3D R = 0.0 * S + middles / edges"}) {
    SourceFile file = altered(path_of("catmull_clark"), kVertexRule, kInnerRule);
    const auto replace = [&](const std::string& was, const std::string& becomes) {
      const std::size_t at = file.text.find(was);
      ASSERT_NE(at, std::string::npos) << was;
      file.text.replace(at, was.size(), becomes);
    };
    replace("n += 1.0;", "edges += 1.0; if (!h->isBoundary()) n += 1.0;");
    replace("double n = 0.0;", "double n = 0.0; double edges = 0.0;");
    replace("const Vector3D R = middles / n", means);
    const ExerciseReport report = grade_one("catmull_clark", file);
    EXPECT_EQ(causes_of(report), std::set<std::string>{"boundary-like-inside"}) << means;
  }
}

TEST(MisunderstoodRules, SmoothPointsAreNoLinearOnes) {
  SourceFile file = altered(path_of("catmull_clark"), "PolyMesh::catmullClarkPositions() {",
                            "PolyMesh::linearPositions() {");
  EXPECT_EQ(causes_of(grade_one("linear_subdivision", file)),
            std::set<std::string>{"smoothed"});
}

TEST(MisunderstoodRules, EveryCauseThatCanBeNamedIsTried) {
  std::set<std::string> tried{"smoothed"};
  for (const Change& change : kMisunderstood)
    tried.insert(change.rule);
  std::set<std::string> known;
  for (const auto scheme : {RefinementScheme::kLinear, RefinementScheme::kCatmullClark}) {
    for (const Misconception& m : refinement_misconceptions(scheme))
      known.insert(m.name);
  }
  EXPECT_EQ(tried, known);
}

TEST(WrongFacePoints, AreToldOnceAndNotAgainForEdgesAndVertices) {
  const ExerciseReport report = grade_one(
      "catmull_clark",
      altered(path_of("catmull_clark"), "sum / static_cast<double>(f->degree())", "0.9 * sum"));
  for (const CaseReport& c : report.cases) {
    ASSERT_EQ(c.findings.size(), 1U) << c.title;
    EXPECT_EQ(c.findings[0].finding.element[0], 'f');
  }
}

TEST(ARefusal, IsNotToldWhereTheLevelBeforeItIsWrong) {
  const ExerciseReport report = grade_one(
      "loop_refinement", altered(path_of("loop_refinement"), "cutIntoFour(*this, f);", ";"));
  std::size_t wrong = 0;
  for (const CaseReport& c : report.cases) {
    for (const auto& told : c.findings) {
      ++wrong;
      EXPECT_NE(told.finding.rule, "refused") << c.title;
    }
  }
  EXPECT_GT(wrong, 0U);
}

class RightOnTheWhole : public testing::TestWithParam<Change> {};

TEST_P(RightOnTheWhole, HasEveryPointDoneInAnotherWay) {
  const Change& change = GetParam();
  const ExerciseReport report = grade_one(change.exercise, changed(change));
  EXPECT_EQ(report.verdict, Verdict::kPassed) << first_finding(report).actual;
  EXPECT_EQ(report.points, report.max_points);
}

constexpr const char* kRounded =
    "const auto rounded = [](const Vector3D& p) {\n"
    "    return Vector3D(static_cast<float>(p.x), static_cast<float>(p.y), "
    "static_cast<float>(p.z));\n  };\n"
    "  for (auto& entry : refined.vertices) entry.second = rounded(entry.second);\n"
    "  for (auto& entry : refined.edges) entry.second = rounded(entry.second);\n"
    "  for (auto& entry : refined.faces) entry.second = rounded(entry.second);\n"
    "  return refined;";

const Change kRightOnTheWhole[] = {
    {"AnotherApex", "triangulation", "const Size n = sides.size();",
     "std::rotate(sides.begin(), sides.begin() + 1, sides.end()); const Size n = "
     "sides.size();",
     ""},
    {"NewFacesOnly", "triangulation", "f->halfedge() = leaving;",
     "const FaceIter last = newFace(); last->halfedge() = leaving;\n"
     "    leaving->face() = leaving->next()->face() = leaving->next()->next()->face() = last;\n"
     "    deleteFace(f);",
     ""},
    {"LinearInFloat", "linear_subdivision", "return refined;", kRounded, ""},
    {"SmoothInFloat", "catmull_clark", "return refined;", kRounded, ""},
    {"SmoothInOtherTerms", "catmull_clark", kInnerRule,
     "(faces + 2.0 * middles) / (n * n) + (n - 3.0) / n * S", ""},
    {"LoopsOwnWeights", "loop_refinement",
     "const double u = n == 3.0 ? 3.0 / 16.0 : 3.0 / (8.0 * n);",
     "const double c = 3.0 / 8.0 + std::cos(2.0 * std::acos(-1.0) / n) / 4.0;\n"
     "  const double u = (5.0 / 8.0 - c * c) / n;",
     ""},
    {"LoopsFacesInAnotherOrder", "loop_refinement", "old_faces.push_back(f);",
     "old_faces.insert(old_faces.begin(), f);", ""},
    {"MarksTheMesh", "catmull_clark", "return refined;",
     "for (VertexIter v = verticesBegin(); v != verticesEnd(); ++v) { v->isNew = true; "
     "v->newPosition = refined.vertices[v]; }\n  return refined;",
     ""},
};

INSTANTIATE_TEST_SUITE_P(Ways, RightOnTheWhole, testing::ValuesIn(kRightOnTheWhole),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(TheWholeMesh, IsNotSearchedForEachOfItsVertices) {
  const ExerciseReport report =
      grade_one("linear_subdivision",
                altered(path_of("linear_subdivision"), "refined.vertices[v] = v->position;",
                        "for (VertexIter w = verticesBegin(); w != verticesEnd(); ++w)\n"
                        "      if (w == v) refined.vertices[w] = w->position;"));
  EXPECT_EQ(report.verdict, Verdict::kOutOfSteps);
  EXPECT_LT(report.points, report.max_points);
}

}  // namespace
}  // namespace meshgrade
