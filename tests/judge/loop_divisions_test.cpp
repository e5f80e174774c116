#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "grader/judge/loop_divisions.h"

namespace meshgrade {
namespace {

/// A hexagon around vertex 0 with a vertex 7 inside one of its triangles: a boundary, an inner
/// vertex with seven neighbours, one with three.
PolygonMesh hexagon() {
  PolygonMesh mesh;
  mesh.positions = {{0.1, 0.2, 0.9},  {2.1, 0.3, 0.4},   {1.2, 1.9, -0.3}, {-0.8, 1.7, 0.5},
                    {-1.9, 0.1, 0.2}, {-1.1, -1.8, 0.7}, {1.0, -1.6, 0.3}, {1.3, 0.8, 0.6}};
  mesh.polygons = {{0, 1, 7}, {1, 2, 7}, {2, 0, 7}, {0, 2, 3},
                   {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}};
  return mesh;
}

/// Subdivides by the formulas of the page, with the divisions in `whole` done on int.
class Student {
 public:
  Student(const PolygonMesh& mesh, VertexRule rule, std::set<std::string> whole)
      : mesh_(mesh), rule_(rule), whole_(std::move(whole)) {
    for (const auto& t : mesh.polygons) {
      for (std::size_t i = 0; i < 3; ++i)
        opposite_[std::minmax(t[i], t[(i + 1) % 3])].push_back(t[(i + 2) % 3]);
    }
  }

  std::vector<Origin> origins() const {
    std::vector<Origin> all;
    for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v)
      all.push_back({v, v});
    for (const auto& [edge, opposite] : opposite_)
      all.push_back({edge.first, edge.second});
    return all;
  }

  std::vector<Point3> points() const {
    std::vector<Point3> all;
    for (const Origin& o : origins())
      all.push_back(o.is_old() ? old_vertex(o.a) : edge(o));
    return all;
  }

 private:
  double divide(const char* name, int a, int b) const {
    return whole_.count(name) != 0 ? a / b : static_cast<double>(a) / b;  // NOLINT
  }

  Point3 sum(const std::vector<std::uint32_t>& vertices) const {
    Point3 total{};
    for (std::uint32_t v : vertices) {
      for (std::size_t i = 0; i < 3; ++i)
        total[i] += mesh_.positions[v][i];
    }
    return total;
  }

  static Point3 combine(double s, const Point3& a, double t, const Point3& b) {
    return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
  }

  Point3 edge(const Origin& e) const {
    const std::vector<std::uint32_t>& opposite = opposite_.at({e.a, e.b});
    const Point3 ends = sum({e.a, e.b});
    if (opposite.size() == 1) return combine(divide("1/2", 1, 2), ends, 0.0, ends);
    return combine(divide("3/8", 3, 8), ends, divide("1/8", 1, 8), sum(opposite));
  }

  double weight(int n) const {
    if (rule_ == VertexRule::kWarren)
      return n == 3 ? divide("3/16", 3, 16) : divide("3 / (8 n)", 3, 8 * n);
    const double c = divide("3/8 in the weight of old vertices", 3, 8) +
                     divide("1/4", 1, 4) * std::cos(2.0 * std::numbers::pi / n);
    return divide("1/n", 1, n) * (divide("5/8", 5, 8) - c * c);
  }

  Point3 old_vertex(std::uint32_t v) const {
    std::vector<std::uint32_t> all;
    std::vector<std::uint32_t> along;
    for (const auto& [edge, opposite] : opposite_) {
      if (edge.first != v && edge.second != v) continue;
      const std::uint32_t other = edge.first == v ? edge.second : edge.first;
      all.push_back(other);
      if (opposite.size() == 1) along.push_back(other);
    }
    const Point3& p = mesh_.positions[v];
    if (!along.empty())
      return combine(divide("3/4", 3, 4), p, divide("1/8 of the boundary", 1, 8), sum(along));
    const auto n = static_cast<int>(all.size());
    return combine(1.0 - n * weight(n), p, weight(n), sum(all));
  }

  const PolygonMesh& mesh_;
  VertexRule rule_;
  std::set<std::string> whole_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> opposite_;
};

Misconceptions told(VertexRule rule, const std::set<std::string>& whole) {
  const PolygonMesh mesh = hexagon();
  const Student student(mesh, rule, whole);
  const std::vector<Origin> origins = student.origins();
  RefinedStep step{mesh, origins, {}, {}};
  for (VertexRule allowed : {VertexRule::kWarren, VertexRule::kLoop})
    step.right.push_back({allowed, Student(mesh, allowed, {}).points()});
  return recognize_divisions(step, student.points(), 1e-9);
}

TEST(LoopDivisions, EveryChoiceOfWarrensWeightsIsNamed) {
  const std::array<const char*, 7> divisions{
      "3/8", "1/8", "1/2", "3/4", "1/8 of the boundary", "3/16", "3 / (8 n)"};
  for (unsigned bits = 1; bits < 1U << divisions.size(); ++bits) {
    std::set<std::string> whole;
    std::set<std::string> weights;
    for (std::size_t k = 0; k < divisions.size(); ++k) {
      if ((bits >> k & 1U) == 0) continue;
      whole.insert(divisions[k]);
      weights.insert(k == 4 ? "1/8" : divisions[k]);
    }
    std::string expected;
    for (const std::string& weight : weights)
      expected += (expected.empty() ? "" : " and ") + weight;
    const Misconceptions likely = told(VertexRule::kWarren, whole);
    ASSERT_EQ(likely.size(), 1U) << expected;
    EXPECT_TRUE(likely[0].advice.starts_with(expected + (weights.size() == 1 ? " is" : " are")))
        << expected << ": " << likely[0].advice;
    const bool old_inside_only = bits >> 5U << 5U == bits;
    EXPECT_EQ(likely[0].name, old_inside_only ? "integer-weight" : "integer-division");
  }
}

TEST(LoopDivisions, EachOfLoopsOwnWeightsIsNamed) {
  for (const char* division : {"5/8", "3/8 in the weight of old vertices", "1/4"}) {
    const Misconceptions likely = told(VertexRule::kLoop, {division});
    ASSERT_EQ(likely.size(), 1U) << division;
    EXPECT_TRUE(likely[0].advice.starts_with(std::string(division) + " is divided"))
        << likely[0].advice;
  }
}

TEST(LoopDivisions, OneThroughAWholeNumberIsAWeightOfZeroByEitherRule) {
  const Misconceptions likely = told(VertexRule::kLoop, {"1/n"});
  ASSERT_EQ(likely.size(), 1U);
  EXPECT_EQ(likely[0].name, "integer-weight");
}

TEST(LoopDivisions, NothingIsSaidOfRightAnswersNorOfOthers) {
  for (VertexRule rule : {VertexRule::kWarren, VertexRule::kLoop})
    EXPECT_TRUE(told(rule, {}).empty());
  const PolygonMesh mesh = hexagon();
  const Student student(mesh, VertexRule::kWarren, {"3/8"});
  const std::vector<Origin> origins = student.origins();
  const RefinedStep step{mesh, origins, {{VertexRule::kWarren, student.points()}}, {}};
  std::vector<Point3> moved = student.points();
  moved.back()[0] += 0.01;
  EXPECT_TRUE(recognize_divisions(step, moved, 1e-9).empty());
}

}  // namespace
}  // namespace meshgrade
