#include <gtest/gtest.h>

#include <cmath>

#include "mesh_invariants.h"
#include "meshedit/meshedit.h"
#include "sample_meshes.h"

namespace meshedit {
namespace {

TEST(VertexNormal, PointsAwayFromTheCenterOfARegularSolid) {
  for (const Polygons& polygons : {tetrahedron(), octahedron(), cube_with_centers()}) {
    const HalfedgeMesh mesh = mesh_of(polygons);
    for (VertexCIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
      EXPECT_NEAR((v->normal() - v->position.unit()).norm(), 0.0, 1e-15);
    }
  }
}

TEST(VertexNormal, OfAFlatSheetIsUpAlsoOnItsBoundary) {
  for (const Polygons& polygons : {sheet(3, 2), frame(), triangle(), fan(5, false)}) {
    const HalfedgeMesh mesh = mesh_of(polygons);
    for (VertexCIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
      EXPECT_NEAR((v->normal() - Vector3D(0, 0, 1)).norm(), 0.0, 1e-15);
    }
  }
}

// Two triangles at the origin: one of area 1 that faces up and one of area 3 that faces along
// x. Their sum has the direction (3, 0, 1).
TEST(VertexNormal, WeighsFacesByTheirAreas) {
  HalfedgeMesh mesh;
  mesh.build({{0, 1, 2}, {0, 2, 3}}, {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 6}});
  const Vector3D expected = Vector3D(3, 0, 1) / std::sqrt(10.0);
  EXPECT_NEAR((mesh.verticesBegin()->normal() - expected).norm(), 0.0, 1e-15);
}

TEST(VertexNormal, DoesNotDependOnWhichHalfedgeTheVertexNames) {
  Polygons polygons = sheet(2, 2);
  polygons.positions[4].z = 0.7;
  polygons.positions[5].z = -0.3;
  HalfedgeMesh mesh = mesh_of(polygons);
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    const Vector3D expected = v->normal();
    const HalfedgeIter first = v->halfedge();
    do {
      v->halfedge() = v->halfedge()->twin()->next();
      EXPECT_NEAR((v->normal() - expected).norm(), 0.0, 1e-15);
    } while (v->halfedge() != first);
  }
}

}  // namespace
}  // namespace meshedit
