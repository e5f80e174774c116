#include "grader/subdivide/opensubdiv_level.h"

#include <gtest/gtest.h>

#include <set>

#include "grader/base/errors.h"
#include "tests/subdivide/course_meshes.h"

namespace meshgrade {
namespace {

TEST(OpensubdivLoop, OctahedronKeepsItsCornersByTheClosedForm) {
  // The four neighbours of a corner sum to zero, so that it moves to 1 - 4 b of itself.
  const PolygonMesh& mesh = triangle_mesh("octahedron.off");
  const SubdivisionLevel loop = opensubdiv_loop(mesh, VertexRule::kLoop, CornerRule::kSmooth);
  const SubdivisionLevel warren =
      opensubdiv_loop(mesh, VertexRule::kWarren, CornerRule::kSmooth);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double old = mesh.positions[v][axis];
      EXPECT_NEAR(loop.mesh.positions[loop.child_of_vertex[v]][axis],
                  (1 - 4 * 0.12109375) * old, 1e-15);
      EXPECT_NEAR(warren.mesh.positions[warren.child_of_vertex[v]][axis],
                  (1 - 4 * 0.09375) * old, 1e-15);
    }
  }
}

TEST(OpensubdivLoop, EdgePointsInsideAreThreeEighthsAndOneEighth) {
  const PolygonMesh& mesh = triangle_mesh("two_triangles.obj");
  const SubdivisionLevel level = opensubdiv_loop(mesh, VertexRule::kLoop, CornerRule::kSmooth);
  bool found = false;
  for (std::size_t e = 0; e < level.edges.size(); ++e) {
    const std::set<std::uint32_t> ends(level.edges[e].begin(), level.edges[e].end());
    const Point3& point = level.mesh.positions[level.child_of_edge[e]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = [&](std::uint32_t v) { return mesh.positions[v][axis]; };
      if (ends == std::set<std::uint32_t>{0, 2}) {
        found = true;
        EXPECT_NEAR(point[axis], 3.0 / 8 * (at(0) + at(2)) + 1.0 / 8 * (at(1) + at(3)), 1e-15);
      } else {
        EXPECT_NEAR(point[axis], (at(*ends.begin()) + at(*ends.rbegin())) / 2, 1e-15);
      }
    }
  }
  EXPECT_TRUE(found);
}

TEST(OpensubdivLoop, EveryVertexHasOneParent) {
  for (const auto& [name, mesh] : triangle_meshes()) {
    const SubdivisionLevel level =
        opensubdiv_loop(mesh, VertexRule::kWarren, CornerRule::kCorner);
    std::set<std::uint32_t> children(level.child_of_vertex.begin(),
                                     level.child_of_vertex.end());
    children.insert(level.child_of_edge.begin(), level.child_of_edge.end());
    EXPECT_EQ(level.child_of_edge.size(), level.edges.size()) << name;
    EXPECT_EQ(children.size(), mesh.positions.size() + level.edges.size()) << name;
    EXPECT_EQ(level.mesh.positions.size(), children.size()) << name;
    EXPECT_EQ(level.mesh.polygons.size(), 4 * mesh.polygons.size()) << name;
  }
}

TEST(OpensubdivLoop, CornerRuleDecidesAboutVerticesOfOneFace) {
  const PolygonMesh& mesh = triangle_mesh("single_triangle.obj");
  const SubdivisionLevel smooth = opensubdiv_loop(mesh, VertexRule::kLoop, CornerRule::kSmooth);
  const SubdivisionLevel corner = opensubdiv_loop(mesh, VertexRule::kLoop, CornerRule::kCorner);
  EXPECT_EQ(smooth.mesh.positions[smooth.child_of_vertex[0]], (Point3{1.0 / 8, 1.0 / 8, 0}));
  EXPECT_EQ(corner.mesh.positions[corner.child_of_vertex[0]], (Point3{0, 0, 0}));
}

TEST(OpensubdivLoop, PolygonsThatAreNoTrianglesAreNamed) {
  const PolygonMesh cube = read_mesh(MESHGRADE_SOURCE_DIR "/meshes/quad_cube.dae").mesh;
  try {
    opensubdiv_loop(cube, VertexRule::kLoop, CornerRule::kSmooth);
    FAIL() << "a cube of squares was taken";
  } catch (const UserError& error) {
    EXPECT_NE(std::string(error.what()).find("f0 has 4 corners"), std::string::npos);
  }
}

}  // namespace
}  // namespace meshgrade
