// The exercise simplification, from source to report: wrong solutions that are the reference
// but for a line, what each probably comes from, right ones done in another way, and whom a
// wrong collapse is blamed on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "grader/judge/collapse_search.h"
#include "tests/grade/graded_change.h"

namespace meshgrade {
namespace {

/// Graded together with an edge_collapse.
ExerciseReport grade_with(SourceFile simplification, SourceFile collapse,
                          const Assignment& assignment) {
  static const Home home = find_home();
  simplification.name = "simplification.cpp";
  collapse.name = "edge_collapse.cpp";
  Submission submission;
  submission.name = "test";
  submission.sources = {std::move(simplification), std::move(collapse)};
  const Report report =
      grade(assignment, submission, home, {"simplification"}, [](const std::string&) {});
  return report.exercises.at(0);
}

ExerciseReport grade_change(const Change& change, const Assignment& assignment) {
  return grade_with(altered(path_of("simplification"), change.was, change.becomes),
                    reference_file(path_of("edge_collapse")), assignment);
}

const Assignment& what_tells_mistakes() {
  static const Assignment assignment =
      only_groups("simplification", {"basic", "several", "refused", "shape"});
  return assignment;
}

const Assignment& what_tells_causes() {
  static const Assignment assignment = only_groups("simplification", {"basic", "several"});
  return assignment;
}

const Assignment& whole_assignment() {
  static const Assignment assignment = load_assignment("polygon_meshes");
  return assignment;
}

class WrongSimplification : public testing::TestWithParam<Change> {};

TEST_P(WrongSimplification, LosesPointsAndIsToldWhy) {
  const ExerciseReport report = grade_change(GetParam(), what_tells_mistakes());
  EXPECT_NE(report.verdict, Verdict::kPassed);
  EXPECT_LT(report.points, report.max_points);
  const Finding& finding = first_finding(report);
  EXPECT_EQ(finding.rule, GetParam().rule) << finding.actual;
  EXPECT_FALSE(finding.meaning.empty());
  EXPECT_FALSE(finding.look_at.empty());
}

constexpr const char* kRefusal = "if (!left) continue;";

const Change kWrongSimplifications[] = {
    {"DoesNothing", "simplification", "while (static_cast<double>(nFaces()) > goal) {",
     "while (false) {", "goal"},
    {"NeverStops", "simplification", "while (static_cast<double>(nFaces()) > goal) {",
     "while (nFaces() > 4) {", "goal"},
    {"DoesOneCollapseMore", "simplification", "while (static_cast<double>(nFaces()) > goal) {",
     "while (static_cast<double>(nFaces()) > goal - 6.0) {", "goal"},
    {"ReturnsTheWrongWord", "simplification", "return true;", "return false;", "returned"},
    {"SaysThatItIsDone", "simplification", "if (candidates.empty()) return false;",
     "if (candidates.empty()) return true;", "goal"},
    {"GivesUpAtTheFirstRefusal", "simplification", kRefusal, "if (!left) return false;",
     "gave-up"},
    {"TakesTheValueOfARefusal", "simplification", kRefusal, "(void)left.value();", "exception"},
    {"CountsTwoFacesLessWhateverHappens", "simplification",
     "const double goal = ratio * static_cast<double>(nFaces());",
     "const double goal = ratio * static_cast<double>(nFaces());\n"
     "  double n = static_cast<double>(nFaces()) + 2.0;\n"
     "  const auto nFaces = [&] { return n -= 2.0; };",
     "goal"},
    {"DoesNotTestForASingularMatrix", "simplification",
     "if (det <= 1e-6 * size * size * size) {", "if (size < 0.0) {", "finite"},
    {"EdgesNotRenewed", "simplification", "remove(e);\n      add(e);", "remove(e);", "gave-up"},
    {"MovesAnotherVertexAsWell", "simplification", "(*left)->position = best;",
     "(*left)->position = best; verticesBegin()->position *= 1.5;", "cheapest"},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, WrongSimplification,
                         testing::ValuesIn(kWrongSimplifications),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// `rule` is the cause that is named.
class MisunderstoodSimplification : public testing::TestWithParam<Change> {};

TEST_P(MisunderstoodSimplification, IsNamedAlone) {
  const ExerciseReport report = grade_change(GetParam(), what_tells_causes());
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_EQ(causes_of(report), std::set<std::string>{GetParam().rule})
      << first_finding(report).rule << ": " << first_finding(report).actual;
}

constexpr const char* kAdd = "costs_[e] = cost;\n    order_.insert({cost, e});";

const Change kMisunderstoodSimplifications[] = {
    {"OffsetSign", "simplification", "const double d = -dot(n, p);",
     "const double d = dot(n, p);", "offset-sign"},
    {"OptimumSign", "simplification", "const Vector3D r = -K.b;", "const Vector3D r = K.b;",
     "optimum-sign"},
    {"Middle", "simplification", "Vector3D bestPoint(const ErrorQuadric& K, EdgeIter e) {",
     "Vector3D bestPoint(const ErrorQuadric& K, EdgeIter e) {\n"
     "  if (K.c < 1e300) return 0.5 * (e->halfedge()->vertex()->position + "
     "e->halfedge()->twin()->vertex()->position);",
     "middle"},
    {"EndsAndMiddle", "simplification",
     "Vector3D bestPoint(const ErrorQuadric& K, EdgeIter e) {",
     "Vector3D bestPoint(const ErrorQuadric& K, EdgeIter e) {\n"
     "  const Vector3D s = e->halfedge()->vertex()->position;\n"
     "  const Vector3D t = e->halfedge()->twin()->vertex()->position;\n"
     "  Vector3D most = 0.5 * (s + t);\n"
     "  if (K.at(s) < K.at(most)) most = s;\n  if (K.at(t) < K.at(most)) most = t;\n"
     "  if (K.c < 1e300) return most;",
     "ends-and-middle"},
    {"NotMoved", "simplification", "(*left)->position = best;", "(void)best;", "not-moved"},
    {"DearestFirst", "simplification", "return order_.begin()->second;",
     "return order_.rbegin()->second;", "dearest-first"},
    {"ShortestFirst", "simplification", "const double cost = K.at(bestPoint(K, e));",
     "const double cost = (e->halfedge()->vertex()->position - "
     "e->halfedge()->twin()->vertex()->position).norm(); (void)K;",
     "shortest-first"},
    {"NotNormalized", "simplification", "const Vector3D n = normal.unit();",
     "const Vector3D n = normal;", "not-normalized"},
    {"QuadricsAnew", "simplification", "quadrics_[v] = K;",
     "ErrorQuadric sum; (void)K;\n    HalfedgeIter s = v->halfedge();\n    do {\n"
     "      if (!s->isBoundary()) sum = sum + quadricOf(s->face());\n"
     "      s = s->twin()->next();\n    } while (s != v->halfedge());\n    quadrics_[v] = sum;",
     "quadrics-anew"},
    {"SharedFacesOnce", "simplification",
     "return quadrics_.at(h->vertex()) + quadrics_.at(h->twin()->vertex());",
     "ErrorQuadric sum = quadrics_.at(h->vertex()) + quadrics_.at(h->twin()->vertex());\n"
     "    for (HalfedgeIter side : {h, h->twin()}) {\n"
     "      if (side->isBoundary()) continue;\n"
     "      const ErrorQuadric q = quadricOf(side->face());\n"
     "      sum = sum + ErrorQuadric{{-q.A[0], -q.A[1], -q.A[2]}, -q.b, -q.c};\n    }\n"
     "    return sum;",
     "shared-faces-once"},
    {"FirstInList", "simplification", kAdd,
     "costs_[e] = 0.0; (void)cost;\n    order_.insert({0.0, e});", "first-in-list"},
    {"LastInList", "simplification", kAdd,
     "costs_[e] = -static_cast<double>(costs_.size()); (void)cost;\n"
     "    order_.insert({costs_[e], e});",
     "last-in-list"},
};

INSTANTIATE_TEST_SUITE_P(Causes, MisunderstoodSimplification,
                         testing::ValuesIn(kMisunderstoodSimplifications),
                         [](const auto& tested) { return std::string(tested.param.name); });

class RightSimplification : public testing::TestWithParam<Change> {};

TEST_P(RightSimplification, HasEveryPointDoneInAnotherWay) {
  const ExerciseReport report = grade_change(GetParam(), whole_assignment());
  EXPECT_EQ(report.verdict, Verdict::kPassed)
      << first_finding(report).rule << ": " << first_finding(report).expected << "; "
      << first_finding(report).actual;
  EXPECT_EQ(report.points, report.max_points);
}

const Change kRightSimplifications[] = {
    {"AsItIs", "simplification", "// Returns false", "// returns false", ""},
    {"AreasWeigh", "simplification", "return {{n.x * n, n.y * n, n.z * n}, d * n, d * d};",
     "const double w = normal.norm();\n"
     "  return {{w * n.x * n, w * n.y * n, w * n.z * n}, w * d * n, w * d * d};",
     ""},
    {"InFloat", "simplification", "return {{n.x * n, n.y * n, n.z * n}, d * n, d * d};",
     "const auto rounded = [](const Vector3D& v) {\n"
     "    return Vector3D(static_cast<float>(v.x), static_cast<float>(v.y),\n"
     "                    static_cast<float>(v.z));\n  };\n"
     "  return {{rounded(n.x * n), rounded(n.y * n), rounded(n.z * n)}, rounded(d * n), "
     "static_cast<float>(d * d)};",
     ""},
    {"BestOfThreeWhereSingular", "simplification",
     "if (curve > 0.0) return p + std::min(1.0, std::max(0.0, -0.5 * slope / curve)) * (q - "
     "p);",
     "(void)slope; if (middle < start && middle < end) return 0.5 * (p + q);", ""},
    {"RefusesWhatTurnsAFace", "simplification",
     "const std::optional<VertexIter> left = collapseEdge(e);",
     "bool turns = false;\n"
     "    const VertexIter a = e->halfedge()->vertex();\n"
     "    const VertexIter b = e->halfedge()->twin()->vertex();\n"
     "    for (VertexIter end : {a, b}) {\n"
     "      HalfedgeIter h = end->halfedge();\n"
     "      do {\n"
     "        const VertexIter p = h->next()->vertex();\n"
     "        const VertexIter q = h->next()->next()->vertex();\n"
     "        if (!h->isBoundary() && p != a && p != b && q != a && q != b)\n"
     "          turns = turns || dot(cross(p->position - end->position, q->position - "
     "end->position), cross(p->position - best, q->position - best)) <= 0.0;\n"
     "        h = h->twin()->next();\n"
     "      } while (h != end->halfedge());\n"
     "    }\n"
     "    if (turns) continue;\n"
     "    const std::optional<VertexIter> left = collapseEdge(e);",
     ""},
    {"StopsByEdges", "simplification",
     "const double goal = ratio * static_cast<double>(nFaces());\n"
     "  Candidates candidates(*this);\n"
     "  while (static_cast<double>(nFaces()) > goal) {",
     "const double goal = ratio * static_cast<double>(nEdges());\n"
     "  Candidates candidates(*this);\n"
     "  while (static_cast<double>(nEdges()) > goal) {",
     ""},
    {"GoalRoundedDown", "simplification",
     "const double goal = ratio * static_cast<double>(nFaces());",
     "const double goal = std::floor(ratio * static_cast<double>(nFaces()));", ""},
    {"GoalRoundedUp", "simplification",
     "const double goal = ratio * static_cast<double>(nFaces());",
     "const double goal = std::ceil(ratio * static_cast<double>(nFaces()));", ""},
    {"TiesTheOtherWayRound", "simplification", "std::set<std::pair<double, EdgeIter>> order_;",
     "using Entry = std::pair<double, EdgeIter>;\n"
     "  struct LastFirst {\n"
     "    bool operator()(const Entry& x, const Entry& y) const {\n"
     "      return x.first != y.first ? x.first < y.first : y.second < x.second;\n"
     "    }\n  };\n"
     "  std::set<Entry, LastFirst> order_;",
     ""},
};

INSTANTIATE_TEST_SUITE_P(Ways, RightSimplification, testing::ValuesIn(kRightSimplifications),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(SimplificationCauses, OldCostsAreNamed) {
  SourceFile file = altered(path_of("simplification"), "      candidates.remove(other);\n",
                            "      candidates.removeIfGone(other, *left);\n");
  const auto replace = [&](const std::string& was, const std::string& becomes) {
    const std::size_t at = file.text.find(was);
    ASSERT_NE(at, std::string::npos) << was;
    file.text.replace(at, was.size(), becomes);
  };
  replace("      remove(e);\n      add(e);\n", "      (void)e;\n");
  replace("  // A vertex has moved",
          "  void removeIfGone(EdgeIter e, VertexIter v) {\n"
          "    for (EdgeIter other : edgesAt(v)) if (other == e) return;\n"
          "    remove(e);\n  }\n\n  // A vertex has moved");
  const ExerciseReport report =
      grade_with(file, reference_file(path_of("edge_collapse")), what_tells_causes());
  EXPECT_EQ(causes_of(report), std::set<std::string>{"costs-not-renewed"});
}

TEST(SimplificationCauses, AreAllTried) {
  std::set<std::string> tried{"costs-not-renewed"};
  for (const Change& change : kMisunderstoodSimplifications)
    tried.insert(change.rule);
  std::set<std::string> known{"first-in-list", "last-in-list"};
  for (const CollapseWay& way : wrong_collapse_ways())
    known.insert(way.name);
  EXPECT_EQ(tried, known);
}

TEST(AWrongCollapse, IsNotToldAsAWrongSimplification) {
  const ExerciseReport report =
      grade_with(reference_file(path_of("simplification")),
                 altered(path_of("edge_collapse"), "deleteVertex(b);", ""), whole_assignment());
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_THAT(report.notes, testing::Contains("your own edge_collapse is part of this and "
                                              "fails: see there first"));
}

TEST(AMissingCollapse, IsNotToldAsAWrongSimplification) {
  SourceFile none = reference_file(path_of("edge_collapse"));
  none.text = "#include \"meshedit/meshedit.h\"\n";
  const ExerciseReport report =
      grade_with(reference_file(path_of("simplification")), none, whole_assignment());
  EXPECT_EQ(report.points, report.max_points);
}

TEST(Simplification, MayNotSearchAllEdgesForEachCollapse) {
  const ExerciseReport report = grade_change(
      {"SearchesAll", "simplification", "const EdgeIter e = candidates.cheapest();",
       "EdgeIter e = candidates.cheapest();\n"
       "    for (EdgeIter k = edgesBegin(); k != edgesEnd(); ++k) {\n"
       "      if (k->halfedge()->vertex() == k->halfedge()->twin()->vertex()) e = k;\n    }",
       ""},
      only_groups("simplification", {"stress"}));
  EXPECT_EQ(report.verdict, Verdict::kOutOfSteps);
}

}  // namespace
}  // namespace meshgrade
