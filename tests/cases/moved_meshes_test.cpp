#include "grader/cases/moved_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "grader/base/wire.h"
#include "grader/cases/bezier_input.h"
#include "grader/cases/mesh_input.h"
#include "grader/judge/normals.h"
#include "grader/judge/point_compare.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

PolygonMesh sample() {
  Random random(7, "moved");
  return shaken(in_build_order(sample_polygons("cube_crossed.obj")), random);
}

std::map<std::string, PolygonMesh> by_name(const PolygonMesh& mesh) {
  std::map<std::string, PolygonMesh> meshes;
  for (const MovedMesh& moved : moved_meshes(mesh, {0, 1}))
    meshes[moved.how] = moved.mesh;
  return meshes;
}

std::set<double> angles_between(const std::vector<Point3>& normals) {
  std::set<double> all;
  for (const Point3& a : normals) {
    for (const Point3& b : normals)
      all.insert(std::round(1e9 * (a[0] * b[0] + a[1] * b[1] + a[2] * b[2])));
  }
  return all;
}

TEST(MovedMeshes, HaveTheNormalsOfTheFirstOneUnderTheSameMap) {
  const PolygonMesh mesh = sample();
  const auto right = angles_between(vertex_normals(mesh, NormalWeight::kArea));
  for (const auto& [how, moved] : by_name(mesh))
    EXPECT_EQ(angles_between(vertex_normals(moved, NormalWeight::kArea)), right) << how;
}

TEST(MovedMeshes, AreAsLargeAsTheySay) {
  const PolygonMesh mesh = sample();
  const double size = extent(mesh.positions);
  const auto moved = by_name(mesh);
  EXPECT_NEAR(extent(moved.at("1,000,000 times smaller").positions), 1e-6 * size, 1e-15);
  EXPECT_NEAR(extent(moved.at("1,000,000 times larger").positions), 1e6 * size, 1e-3);
  EXPECT_GT(largest_coordinate(moved.at("far from the origin").positions), 15.0 * size);
}

TEST(MovedMeshes, PutAVertexOrAMidpointAtTheOrigin) {
  const auto moved = by_name(sample());
  EXPECT_EQ(moved.at("with a vertex at the origin").positions[0], Point3{});
  const auto& middle = moved.at("with the middle of an edge at the origin").positions;
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(middle[0][i] + middle[1][i], 0.0);
}

TEST(MovedMeshes, AreTheSameInFloatWhereAFloatSolutionMustNotPayForIt) {
  for (const auto& [how, moved] : by_name(sample())) {
    if (how.find("origin") == std::string::npos && how != "mirrored") continue;
    for (const Point3& p : moved.positions) {
      for (double x : p)
        EXPECT_EQ(static_cast<double>(static_cast<float>(x)), x) << how;
    }
  }
}

TEST(MovedMeshes, AreInBuildOrder) {
  const auto is_ordered = [](const PolygonMesh& mesh) {
    return in_build_order(mesh).positions == mesh.positions;
  };
  Random random(7, "moved");
  for (const auto& [how, moved] : by_name(sample()))
    EXPECT_TRUE(is_ordered(moved)) << how;
  EXPECT_TRUE(is_ordered(many_valences(13, 24, random)));
  EXPECT_TRUE(is_ordered(open_fan(22)));
  EXPECT_TRUE(is_ordered(open_grid(16, random)));
  EXPECT_TRUE(is_ordered(two_sizes(sample(), sample(), random)));
  EXPECT_TRUE(is_ordered(side_by_side(sample(), sample())));
}

TEST(MovedMeshes, MirroredOnesAreWoundTheOtherWay) {
  const auto volume = [](const PolygonMesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.polygons) {
      const Point3& a = mesh.positions[t[0]];
      const Point3& b = mesh.positions[t[1]];
      const Point3& c = mesh.positions[t[2]];
      sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum;
  };
  const PolygonMesh mesh = sample();
  EXPECT_GT(volume(mesh), 0.0);
  EXPECT_NEAR(volume(by_name(mesh).at("mirrored")), volume(mesh), 1e-9);
}

/// The valences of all vertices that the cases of an exercise have.
template <class Input>
std::set<std::size_t> valences_in(const std::string& exercise) {
  std::set<std::size_t> all;
  for (const Case& c : standard_cases(exercise)) {
    const PolygonMesh mesh = from_wire<Input>(c.input).mesh;
    std::map<std::uint32_t, std::size_t> valence;
    for (const auto& t : mesh.polygons) {
      for (std::uint32_t corner : t)
        ++valence[corner];
    }
    for (const auto& [vertex, n] : valence)
      all.insert(n);
  }
  return all;
}

TEST(MovedMeshes, EveryMeshExerciseHasEveryValenceFrom3To24) {
  const std::map<std::string, std::set<std::size_t>> found{
      {"vertex_normal", valences_in<NormalInput>("vertex_normal")},
      {"loop_subdivision", valences_in<SubdivisionInput>("loop_subdivision")},
      {"edge_flip", valences_in<OperationsInput>("edge_flip")},
      {"edge_split", valences_in<OperationsInput>("edge_split")}};
  for (const auto& [exercise, valences] : found) {
    for (std::size_t n = 3; n <= 24; ++n)
      EXPECT_EQ(valences.count(n), 1U) << exercise << " " << n;
  }
}

TEST(MovedMeshes, EveryExerciseHasACaseInAProcessOfItsOwn) {
  for (const ExerciseRubric& rubric : standard_rubric().exercises) {
    const std::vector<Case>& cases = standard_cases(rubric.name);
    EXPECT_TRUE(std::any_of(cases.begin(), cases.end(), [](const Case& c) { return c.fresh; }))
        << rubric.name;
  }
}

TEST(BezierCases, HaveNetsOfAllSizesFrom2To8AndAGridOfParameters) {
  std::set<std::pair<std::size_t, std::size_t>> sizes;
  std::set<double> parameters;
  for (const Case& c : standard_cases("bezier_patch")) {
    const auto input = from_wire<PatchInput>(c.input);
    for (const auto& [u, v] : input.parameters)
      parameters.insert({u, v});
    if (input.function == PatchFunction::kSurface)
      sizes.emplace(input.net.size(), input.net[0].size());
  }
  for (std::size_t rows = 2; rows <= 8; ++rows) {
    for (std::size_t columns = 2; columns <= 8; ++columns)
      EXPECT_EQ(sizes.count({rows, columns}), 1U) << rows << " x " << columns;
  }
  EXPECT_EQ(sizes.count({24, 2}), 1U);
  for (double t : {0.25, 0.5, 0.75, 1.0 / 1024.0, 1.0 - 1.0 / 1024.0})
    EXPECT_EQ(parameters.count(t), 1U) << t;
}

}  // namespace
}  // namespace meshgrade
