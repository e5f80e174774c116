#include "grader/judge/bezier_forms.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "grader/base/random.h"

namespace meshgrade {
namespace {

using Point = std::array<double, 2>;

std::vector<Point> random_points(std::size_t count, Random& random) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({random.between(-5, 5), random.between(-5, 5)});
  return points;
}

TEST(BezierForms, BernsteinIsRepeatedDeCasteljau) {
  Random random(1, "forms");
  for (std::size_t count = 1; count <= 20; ++count) {
    const std::vector<Point> points = random_points(count, random);
    for (double t : {0.0, 0.25, random.unit(), 1.0}) {
      std::vector<Point> level = points;
      while (level.size() > 1)
        level = de_casteljau_step(level, t);
      const Point direct = bernstein(points, t);
      EXPECT_NEAR(direct[0], level[0][0], 1e-12);
      EXPECT_NEAR(direct[1], level[0][1], 1e-12);
    }
  }
}

TEST(BezierForms, BernsteinPolynomialsSumToOneAndAreBinomialTerms) {
  for (std::size_t n = 1; n <= 12; ++n) {
    for (double t : {0.0, 0.3, 1.0}) {
      double sum = 0.0;
      double binomial = 1.0;
      for (std::size_t i = 0; i <= n; ++i) {
        std::vector<std::array<double, 1>> unit(n + 1, {0.0});
        unit[i] = {1.0};
        const double weight = bernstein(unit, t)[0];
        const auto k = static_cast<double>(i);
        EXPECT_NEAR(weight,
                    binomial * std::pow(t, k) * std::pow(1 - t, static_cast<double>(n) - k),
                    1e-13);
        sum += weight;
        binomial *= (static_cast<double>(n) - k) / (k + 1);
      }
      EXPECT_NEAR(sum, 1.0, 1e-14);
    }
  }
}

TEST(BezierForms, CurveBeginsAndEndsAtItsEndPoints) {
  Random random(2, "ends");
  const std::vector<Point> points = random_points(7, random);
  EXPECT_EQ(bernstein(points, 0.0), points.front());
  EXPECT_EQ(bernstein(points, 1.0), points.back());
}

TEST(BezierForms, ParabolaHasItsKnownPoint) {
  const Point middle = bernstein(std::vector<Point>{{0, 0}, {1, 2}, {2, 0}}, 0.5);
  EXPECT_DOUBLE_EQ(middle[0], 1.0);
  EXPECT_DOUBLE_EQ(middle[1], 1.0);
}

TEST(BezierForms, StepMakesOnePointLess) {
  EXPECT_EQ(de_casteljau_step(std::vector<Point>{{0, 0}, {4, 8}, {8, 0}}, 0.25),
            (std::vector<Point>{{1, 2}, {5, 6}}));
  EXPECT_TRUE(de_casteljau_step(std::vector<Point>{{1, 1}}, 0.5).empty());
}

}  // namespace
}  // namespace meshgrade
