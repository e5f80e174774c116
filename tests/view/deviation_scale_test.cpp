// How distances from OpenSubdiv's answer are measured, told and coloured.

#include "grader/view/deviation_scale.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

/// How light a colour is for the eye, 0 to 1, by the weights of sRGB.
double lightness(const std::string& color) {
  double sum = 0.0;
  const double weights[] = {0.2126, 0.7152, 0.0722};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = std::stoi(color.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    sum += weights[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}

/// The cube as an expected surface, and the same with one vertex moved.
Deviation cube_with_vertex_moved(Ref vertex, double by, double allowed = 1e-5) {
  MeshDump mesh = sample_dump("cube.obj");
  std::vector<Point3> expected;
  std::vector<Ref> match;
  for (Ref v = 0; v < mesh.vertices.size(); ++v) {
    expected.push_back(mesh.vertices[v].position);
    match.push_back(v);
  }
  mesh.vertices[vertex].position[0] += by;
  return measure_deviation(expected, mesh, match, std::sqrt(12.0), allowed);
}

TEST(DeviationScale, GetsDarkerAllTheWayAsIsSeenWithoutSeeingColours) {
  const Deviation deviation = cube_with_vertex_moved(3, 0.5);
  const double range = deviation_range(deviation);
  double before = 2.0;
  for (int i = 0; i <= 20; ++i) {
    const double now = lightness(deviation_color(deviation, range * i / 20.0));
    EXPECT_LT(now, before - 0.005) << i;
    before = now;
  }
  EXPECT_EQ(deviation_color(deviation, 0.0), kDeviationColors.front());
  EXPECT_EQ(deviation_color(deviation, range), kDeviationColors.back());
  EXPECT_EQ(deviation_color(deviation, INFINITY), kDeviationColors.back());
}

TEST(DeviationScale, DistancesAreFractionsOfTheDiagonal) {
  const Deviation deviation = cube_with_vertex_moved(3, 0.5);
  EXPECT_NEAR(deviation.largest, 0.5 / std::sqrt(12.0), 1e-15);
  EXPECT_EQ(deviation.worst, std::vector<Ref>{3});
  EXPECT_EQ(deviation_range(deviation), deviation.largest);
  EXPECT_THAT(deviation_text(deviation), testing::HasSubstr("Off: 1 of 8 vertices"));
  EXPECT_THAT(deviation_text(deviation), testing::HasSubstr("v3 is off by 0.144"));
}

TEST(DeviationScale, RoundingErrorsDoNotLookLikeMistakes) {
  const Deviation deviation = cube_with_vertex_moved(3, 1e-15);
  EXPECT_TRUE(deviation.worst.empty());
  EXPECT_GT(deviation.largest, 0.0);
  EXPECT_EQ(deviation_color(deviation, deviation.largest), kDeviationColors.front());
  EXPECT_THAT(deviation_text(deviation),
              testing::StartsWith("Every vertex is where it must be"));
}

TEST(DeviationScale, ACoordinateThatIsNoNumberIsTheWorst) {
  const Deviation deviation = cube_with_vertex_moved(5, NAN);
  ASSERT_EQ(deviation.worst, std::vector<Ref>{5});
  EXPECT_EQ(deviation_color(deviation, deviation.of_vertex[5]), kDeviationColors.back());
  EXPECT_TRUE(std::isfinite(deviation_range(deviation)));
}

}  // namespace
}  // namespace meshgrade
