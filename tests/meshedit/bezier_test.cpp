#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "meshedit/meshedit.h"

namespace meshedit {
namespace {

/// A curve whose parameter can be set from outside.
class OpenCurve : public BezierCurve {
 public:
  explicit OpenCurve(float parameter) : BezierCurve(4) { t = parameter; }
};

double binomial(Index n, Index k) {
  double result = 1.0;
  for (Index i = 1; i <= k; ++i) {
    result *= static_cast<double>(n - k + i) / static_cast<double>(i);
  }
  return result;
}

/// The weight of control point k of n + 1 at t.
double bernstein(Index n, Index k, double t) {
  return binomial(n, k) * std::pow(t, static_cast<double>(k)) *
         std::pow(1.0 - t, static_cast<double>(n - k));
}

std::vector<std::vector<Vector3D>> bumpy_net(Index rows, Index columns) {
  std::vector<std::vector<Vector3D>> net(rows);
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j) {
      const auto x = static_cast<double>(j);
      const auto y = static_cast<double>(i);
      net[i].emplace_back(x, y + 0.25 * x, std::sin(3.0 * x + 5.0 * y));
    }
  }
  return net;
}

Vector3D by_bernstein(const std::vector<std::vector<Vector3D>>& net, double u, double v) {
  Vector3D sum;
  for (Index i = 0; i < net.size(); ++i) {
    for (Index j = 0; j < net[i].size(); ++j) {
      sum += bernstein(net.size() - 1, i, v) * bernstein(net[i].size() - 1, j, u) * net[i][j];
    }
  }
  return sum;
}

TEST(BezierCurve, StepIsOneLevelAtTheCurvesParameter) {
  OpenCurve curve(0.25F);
  const std::vector<Vector2D> points = {{0, 0}, {4, 0}, {4, 8}};
  const std::vector<Vector2D> next = curve.evaluateStep(points);
  ASSERT_EQ(next.size(), 2U);
  EXPECT_EQ(next[0].x, 1.0);
  EXPECT_EQ(next[0].y, 0.0);
  EXPECT_EQ(next[1].x, 4.0);
  EXPECT_EQ(next[1].y, 2.0);
}

TEST(BezierCurve, EndsOfTheParameterAreEndsOfTheSegments) {
  const std::vector<Vector2D> points = {{1, 2}, {3, 5}, {8, 13}};
  const std::vector<Vector2D> starts = OpenCurve(0.0F).evaluateStep(points);
  const std::vector<Vector2D> ends = OpenCurve(1.0F).evaluateStep(points);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    EXPECT_EQ((starts[i] - points[i]).norm(), 0.0);
    EXPECT_EQ((ends[i] - points[i + 1]).norm(), 0.0);
  }
}

TEST(BezierCurve, RepeatedStepsAreTheBernsteinPolynomial) {
  OpenCurve curve(0.375F);
  std::vector<Vector2D> points = {{0, 0}, {1, 3}, {2, -1}, {5, 2}, {6, 6}};
  Vector2D expected;
  for (Index k = 0; k < points.size(); ++k) {
    expected += bernstein(points.size() - 1, k, 0.375) * points[k];
  }
  while (points.size() > 1) {
    points = curve.evaluateStep(points);
  }
  EXPECT_NEAR((points[0] - expected).norm(), 0.0, 1e-14);
}

TEST(BezierPatch, StepAndCurveFollowTheBernsteinPolynomial) {
  const BezierPatch patch;
  const std::vector<Vector3D> points = bumpy_net(1, 6)[0];
  EXPECT_EQ(patch.evaluateStep(points, 0.5).size(), 5U);
  EXPECT_NEAR((patch.evaluateStep(points, 0.5)[2] - (points[2] + points[3]) / 2).norm(), 0.0,
              1e-15);
  EXPECT_NEAR((patch.evaluate1D(points, 0.3) - by_bernstein({points}, 0.3, 0.0)).norm(), 0.0,
              1e-14);
  EXPECT_EQ((patch.evaluate1D({points[4]}, 0.7) - points[4]).norm(), 0.0);
}

TEST(BezierPatch, RowsAreEvaluatedAtUAndTheResultAtV) {
  for (const auto& [rows, columns] : std::vector<std::pair<Index, Index>>{
           {4, 4}, {2, 5}, {5, 2}, {1, 1}, {1, 4}, {3, 1}, {9, 7}}) {
    const auto net = bumpy_net(rows, columns);
    const BezierPatch patch(net);
    for (const double u : {0.0, 0.125, 0.7, 1.0}) {
      for (const double v : {0.0, 0.4, 1.0}) {
        EXPECT_NEAR((patch.evaluate(u, v) - by_bernstein(net, u, v)).norm(), 0.0, 1e-13)
            << rows << " x " << columns << " at " << u << ", " << v;
      }
    }
  }
}

}  // namespace
}  // namespace meshedit
