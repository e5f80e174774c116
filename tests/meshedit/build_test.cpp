#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "mesh_invariants.h"
#include "meshedit/meshedit.h"
#include "sample_meshes.h"

namespace meshedit {
namespace {

/// The message with which build() refuses these polygons over `count` positions. Checks that
/// the mesh stays as it was.
std::string refusal(const std::vector<std::vector<Index>>& polygons,
                    const std::vector<Vector3D>& positions) {
  HalfedgeMesh mesh = mesh_of(octahedron());
  const auto before = full_wiring(mesh);
  std::string message;
  try {
    mesh.build(polygons, positions);
  } catch (const MeshError& error) {
    message = error.what();
  }
  EXPECT_EQ(full_wiring(mesh), before) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  return message;
}

std::string refusal(const std::vector<std::vector<Index>>& polygons, Index count) {
  std::vector<Vector3D> positions;
  for (Index i = 0; i < count; ++i) {
    positions.emplace_back(static_cast<double>(i), static_cast<double>(i * i), 0.0);
  }
  return refusal(polygons, positions);
}

testing::AssertionResult says(const std::string& message,
                              const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    if (message.find(part) == std::string::npos) {
      return testing::AssertionFailure() << '"' << part << "\" is not in \"" << message << '"';
    }
  }
  return testing::AssertionSuccess();
}

TEST(BuildRefuses, PolygonOfTwoCorners) {
  EXPECT_TRUE(says(refusal({{0, 1, 2}, {1, 0}}, 3), {"polygon 1", "2 corners"}));
  EXPECT_TRUE(says(refusal({{}}, 0), {"polygon 0", "0 corners"}));
}

TEST(BuildRefuses, RepeatedCorner) {
  EXPECT_TRUE(says(refusal({{0, 1, 2}, {2, 1, 3, 1}}, 4), {"polygon 1", "vertex 1", "twice"}));
  EXPECT_TRUE(says(refusal({{0, 0, 1}}, 2), {"polygon 0", "vertex 0", "twice"}));
}

TEST(BuildRefuses, CornerOutOfRange) {
  EXPECT_TRUE(says(refusal({{0, 1, 3}}, 3), {"polygon 0", "vertex 3", "only 3"}));
  EXPECT_TRUE(says(refusal({{0, 1, static_cast<Index>(-1)}}, 3), {"polygon 0", "only 3"}));
}

TEST(BuildRefuses, EdgeUsedTwiceInOneDirection) {
  EXPECT_TRUE(
      says(refusal({{0, 1, 2}, {0, 1, 3}}, 4), {"edge 0 -> 1", "polygon 0", "polygon 1"}));
}

TEST(BuildRefuses, SameTriangleTwice) {
  EXPECT_TRUE(says(refusal({{0, 1, 2}, {1, 2, 0}}, 3), {"edge ", "polygon 0", "polygon 1"}));
}

TEST(BuildRefuses, ThirdFaceAtAnEdge) {
  EXPECT_TRUE(says(refusal({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5),
                   {"edge 0 -> 1", "polygon 0", "polygon 2"}));
  EXPECT_TRUE(says(refusal({{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}, 5),
                   {"edge 1 -> 0", "polygon 1", "polygon 2"}));
}

TEST(BuildRefuses, MoebiusStrip) {
  // Five triangles in a ring; the last is glued to the first with a half turn.
  EXPECT_TRUE(says(refusal({{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 0}, {4, 0, 1}}, 5),
                   {"edge ", "opposite directions"}));
}

TEST(BuildRefuses, BowTieOfOpenFans) {
  EXPECT_TRUE(says(refusal({{0, 1, 2}, {2, 3, 4}}, 5), {"vertex 2", "bow-tie"}));
}

TEST(BuildRefuses, BowTieOfClosedFans) {
  // Two tetrahedra that share vertex 0.
  EXPECT_TRUE(says(refusal({{0, 1, 2},
                            {0, 3, 1},
                            {0, 2, 3},
                            {1, 3, 2},
                            {0, 4, 5},
                            {0, 6, 4},
                            {0, 5, 6},
                            {4, 6, 5}},
                           7),
                   {"vertex 0", "bow-tie"}));
}

TEST(BuildRefuses, BowTieOfAClosedAndAnOpenFan) {
  EXPECT_TRUE(says(refusal({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}, {4, 5, 3}}, 6),
                   {"vertex 3", "bow-tie"}));
}

TEST(BuildRefuses, UnusedVertex) {
  EXPECT_TRUE(says(refusal({{0, 1, 3}}, 4), {"vertex 2", "no polygon"}));
  EXPECT_TRUE(says(refusal({}, 1), {"vertex 0", "no polygon"}));
}

TEST(BuildRefuses, PositionsThatAreNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(says(refusal({{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, bad}}),
                     {"vertex 2", "finite"}));
  }
}

TEST(Build, NothingGivesAnEmptyMesh) {
  HalfedgeMesh mesh = mesh_of(octahedron());
  mesh.build({}, {});
  EXPECT_EQ(mesh.nHalfedges() + mesh.nVertices() + mesh.nEdges() + mesh.nFaces(), 0U);
  EXPECT_TRUE(mesh.edgesBegin() == mesh.edgesEnd());
}

TEST(Build, KeepsEveryRule) {
  for (const Polygons& polygons : all_triangle_meshes()) {
    EXPECT_EQ(broken_rule(mesh_of(polygons)), "");
  }
  EXPECT_EQ(broken_rule(mesh_of(cube_of_squares()), false), "");
}

TEST(Build, NumbersVerticesInOrderOfFirstAppearance) {
  HalfedgeMesh mesh;
  mesh.build({{3, 1, 0}, {0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {2, 2, 0}, {3, 0, 3}});
  std::vector<double> xs;
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    xs.push_back(v->position.x);
  }
  EXPECT_EQ(xs, (std::vector<double>{3, 1, 0, 2}));
}

TEST(Build, FacesKeepTheirOrderAndTheirCorners) {
  const Polygons polygons = octahedron();
  HalfedgeMesh mesh = mesh_of(polygons);
  Index i = 0;
  for (FaceIter f = mesh.facesBegin(); f != mesh.facesEnd(); ++f, ++i) {
    HalfedgeIter h = f->halfedge();
    for (const Index corner : polygons.corners[i]) {
      EXPECT_EQ((h->vertex()->position - polygons.positions[corner]).norm(), 0.0);
      h = h->next();
    }
  }
}

TEST(Build, AnchorsOfBoundariesAreWherePromised) {
  HalfedgeMesh mesh = mesh_of(frame());
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    EXPECT_TRUE(v->isBoundary());
    EXPECT_TRUE(v->halfedge()->isBoundary());
    EXPECT_TRUE(v->halfedge()->vertex() == v);
  }
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    EXPECT_FALSE(e->halfedge()->isBoundary());
  }
}

TEST(Build, BoundaryLoopsAreFacesOfTheirOwn) {
  HalfedgeMesh mesh = mesh_of(frame());
  EXPECT_EQ(mesh.nFaces(), 16U);
  ASSERT_EQ(mesh.nBoundaries(), 2U);
  std::vector<Size> lengths;
  for (FaceIter b = mesh.boundariesBegin(); b != mesh.boundariesEnd(); ++b) {
    EXPECT_TRUE(b->isBoundary());
    EXPECT_TRUE(b->halfedge()->isBoundary());
    lengths.push_back(b->degree());
  }
  std::sort(lengths.begin(), lengths.end());
  EXPECT_EQ(lengths, (std::vector<Size>{4, 12}));
}

TEST(Build, EveryComponentHasItsOwnBoundary) {
  const HalfedgeMesh mesh = mesh_of(together(together(triangle(), octahedron()), triangle()));
  EXPECT_EQ(mesh.nBoundaries(), 2U);
}

std::ptrdiff_t euler_characteristic(const HalfedgeMesh& mesh) {
  return static_cast<std::ptrdiff_t>(mesh.nVertices()) -
         static_cast<std::ptrdiff_t>(mesh.nEdges()) +
         static_cast<std::ptrdiff_t>(mesh.nFaces());
}

TEST(Build, EulerCharacteristicIsThatOfTheSurface) {
  EXPECT_EQ(euler_characteristic(mesh_of(tetrahedron())), 2);
  EXPECT_EQ(euler_characteristic(mesh_of(cube_of_squares())), 2);
  EXPECT_EQ(euler_characteristic(mesh_of(torus(7, 4))), 0);
  EXPECT_EQ(euler_characteristic(mesh_of(sheet(5, 2))), 1);
  EXPECT_EQ(euler_characteristic(mesh_of(frame())), 0);
  EXPECT_EQ(euler_characteristic(mesh_of(together(octahedron(), torus(3, 3)))), 2);
}

TEST(Build, DegreesAndLengthsAreThoseOfTheMesh) {
  HalfedgeMesh mesh = mesh_of(sheet(2, 2));
  Size corners = 0;
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    corners += v->degree();
  }
  EXPECT_EQ(corners, 3 * mesh.nFaces());
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    const double length = e->length();
    EXPECT_TRUE(length == 1.0 || length == std::sqrt(2.0)) << length;
  }
  const HalfedgeMesh cube = mesh_of(cube_of_squares());
  Vector3D sum;
  for (FaceCIter f = cube.facesBegin(); f != cube.facesEnd(); ++f) {
    EXPECT_EQ(f->degree(), 4U);
    EXPECT_NEAR(f->normal().norm(), 1.0, 1e-15);
    EXPECT_GT(dot(f->normal(), f->halfedge()->vertex()->position), 0.99);
    sum += f->normal();
  }
  EXPECT_NEAR(sum.norm(), 0.0, 1e-15);
}

TEST(Build, FaceNormalIsAsGoodFarFromTheOrigin) {
  Polygons polygons = tetrahedron();
  const HalfedgeMesh near = mesh_of(polygons);
  for (Vector3D& p : polygons.positions) {
    p += Vector3D(1 << 30, 1 << 29, -(1 << 30));
  }
  const HalfedgeMesh far = mesh_of(polygons);
  FaceCIter f = far.facesBegin();
  for (FaceCIter g = near.facesBegin(); g != near.facesEnd(); ++f, ++g) {
    EXPECT_NEAR((f->normal() - g->normal()).norm(), 0.0, 1e-15);
  }
}

TEST(Build, HubOfTwoHundredThousandTrianglesIsNoProblem) {
  constexpr Index kTriangles = 200000;
  const HalfedgeMesh mesh = mesh_of(fan(kTriangles, true));
  EXPECT_EQ(mesh.nFaces(), kTriangles);
  EXPECT_EQ(mesh.verticesBegin()->degree(), kTriangles);
  EXPECT_EQ(mesh.boundariesBegin()->degree(), kTriangles);
}

TEST(Build, MayBeCalledAgain) {
  HalfedgeMesh mesh = mesh_of(torus(9, 9));
  const Polygons polygons = frame();
  mesh.build(polygons.corners, polygons.positions);
  EXPECT_EQ(broken_rule(mesh), "");
  EXPECT_EQ(mesh.nBoundaries(), 2U);
}

}  // namespace
}  // namespace meshedit
