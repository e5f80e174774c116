// What the judge of simplification is made of, against other sources.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "grader/cases/simplified_shapes.h"
#include "grader/judge/collapse_search.h"
#include "grader/judge/surface_distance.h"
#include "grader/operations/local_operation_list.h"
#include "grader/operations/picked_element.h"
#include "grader/simplify/openmesh_decimation.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

constexpr const char* kTriangleMeshes[] = {
    "tetrahedron.obj",     "octahedron.off",    "icosahedron.obj", "bipyramid_3.obj",
    "single_triangle.obj", "two_triangles.obj", "fan.obj",         "grid_4x4.obj",
    "grid_hole.off",       "double_torus.obj",  "umbrella.obj",    "ring_5.obj"};

FaceLists lists_of(const PolygonMesh& mesh) {
  return {mesh.positions, {mesh.polygons.begin(), mesh.polygons.end()}};
}

TEST(SoundCollapses, AreThoseThatEdgeCollapseMustDo) {
  const LocalOperation& collapse = *find_local_operation("edge_collapse");
  std::map<Demand, int> seen;
  std::vector<PolygonMesh> meshes{hourglass(), winding_band(6)};
  for (const char* file : kTriangleMeshes)
    meshes.push_back(cut_to_triangles(sample_polygons(file)));
  for (const PolygonMesh& mesh : meshes) {
    const FaceLists lists = face_lists_of(built_mesh(mesh));
    const CollapsingMesh collapsing(lists, right_collapse_ways()[0]);
    for (const LabelPair& edge : collapsing.edges()) {
      const Answer answer = collapse.answer(lists, {{edge.first, edge.second}});
      EXPECT_EQ(collapsing.is_sound(edge), answer.demand == Demand::kMust)
          << edge.first << "-" << edge.second << ": " << answer.reason;
      ++seen[answer.demand];
    }
  }
  EXPECT_GT(seen[Demand::kMust], 100);
  EXPECT_GT(seen[Demand::kRefuse], 20);
  EXPECT_GT(seen[Demand::kEither], 10);
}

TEST(AQuadric, IsTheSquaredDistanceFromThePlane) {
  const Quadric q = plane_quadric({1, 0, 3}, {2, 0, 3}, {1, 5, 3});
  EXPECT_NEAR(q.at({7, -2, 3}), 0.0, 1e-12);
  EXPECT_NEAR(q.at({7, -2, 5.5}), 6.25, 1e-12);
}

TEST(AQuadric, IsLeastWhereThreePlanesMeet) {
  const Quadric q = plane_quadric({4, 0, 0}, {4, 1, 0}, {4, 0, 1}) +
                    plane_quadric({0, 5, 0}, {1, 5, 0}, {0, 5, 1}) +
                    plane_quadric({0, 0, 6}, {1, 0, 6}, {0, 1, 6});
  const auto least = least_point(q);
  ASSERT_TRUE(least);
  EXPECT_NEAR((*least)[0], 4.0, 1e-12);
  EXPECT_NEAR((*least)[1], 5.0, 1e-12);
  EXPECT_NEAR((*least)[2], 6.0, 1e-12);
}

TEST(AQuadric, HasNoSingleLeastPointOnAPlaneOrACrease) {
  const Quadric flat = plane_quadric({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Quadric other = plane_quadric({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
  EXPECT_FALSE(least_point(flat + flat));
  EXPECT_FALSE(least_point(flat + other));
}

TEST(TheDistanceOfSurfaces, IsThatOfParallelSquares) {
  const PolygonMesh square{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                           {{0, 1, 2}, {0, 2, 3}}};
  PolygonMesh lifted = square;
  for (Point3& p : lifted.positions)
    p[2] += 0.25;
  EXPECT_NEAR(surface_distance(lists_of(square), lists_of(lifted)), 0.25, 1e-12);
  EXPECT_NEAR(farthest_corner(lists_of(square), lists_of(lifted)), 0.25, 1e-12);
}

TEST(TheCheapestCollapses, LeaveACubeWithItsTwelveTriangles) {
  const PolygonMesh cube = cut_in_four(cut_to_triangles(sample_polygons("quad_cube.dae")));
  const CollapsePath path =
      cheapest_collapses(lists_of(cube), right_collapse_ways()[0], (48 - 12) / 2);
  EXPECT_EQ(path.left.lists().faces.size(), 12U);
  EXPECT_LT(farthest_corner(path.left.lists(), lists_of(cube)), 1e-9);
  EXPECT_LT(farthest_corner(lists_of(cube), path.left.lists()), 1e-9);
}

TEST(TheCheapestCollapses, ComeAsCloseAsOpenMeshesOrCloser) {
  const PolygonMesh ball = cut_in_four(cut_in_four(sample_polygons("icosahedron.obj")));
  const CollapsePath path = cheapest_collapses(lists_of(ball), right_collapse_ways()[0], 100);
  const PolygonMesh other = openmesh_decimation(ball, path.left.lists().faces.size());
  EXPECT_LT(surface_distance(path.left.lists(), lists_of(ball)),
            1.1 * surface_distance(lists_of(other), lists_of(ball)) + 1e-9);
}

TEST(OpenMeshDecimation, ReachesTheNumberOfFaces) {
  for (std::uint32_t which = 0; which < kBumpyShapes; ++which) {
    const PolygonMesh mesh = bumpy_shape(which);
    EXPECT_EQ(openmesh_decimation(mesh, 300).polygons.size(), 300U) << bumpy_shape_name(which);
  }
}

}  // namespace
}  // namespace meshgrade
