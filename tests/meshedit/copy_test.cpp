#include <gtest/gtest.h>

#include <iterator>
#include <memory>

#include "faults.h"
#include "mesh_invariants.h"
#include "meshedit/meshedit.h"
#include "sample_meshes.h"

namespace meshedit {
namespace {

class Copy : public FaultTest {};

TEST_F(Copy, HasTheSameElementsInTheSameOrder) {
  for (const Polygons& polygons : all_triangle_meshes()) {
    const HalfedgeMesh mesh = mesh_of(polygons);
    const HalfedgeMesh copy = mesh;  // NOLINT(performance-unnecessary-copy-initialization)
    EXPECT_EQ(full_wiring(copy), full_wiring(mesh));
    EXPECT_EQ(broken_rule(copy), "");
  }
}

TEST_F(Copy, SharesNothing) {
  HalfedgeMesh mesh = mesh_of(frame());
  HalfedgeMesh copy = mesh;
  VertexIter v = mesh.verticesBegin();
  for (VertexIter w = copy.verticesBegin(); w != copy.verticesEnd(); ++v, ++w) {
    EXPECT_EQ((w->position - v->position).norm(), 0.0);
    w->position += Vector3D(0, 0, 1);
    EXPECT_EQ(v->position.z, 0.0);
  }
  copy.halfedgesBegin()->next() = copy.halfedgesBegin();
  EXPECT_EQ(broken_rule(mesh), "");
}

TEST_F(Copy, SurvivesTheOriginal) {
  auto mesh = std::make_unique<HalfedgeMesh>(mesh_of(torus(8, 8)));
  mesh->edgesBegin()->record.edge = mesh->edgesBegin();
  HalfedgeMesh copy = *mesh;
  mesh.reset();
  EXPECT_EQ(broken_rule(copy), "");
  EXPECT_EQ(copy.nFaces(), 128U);
  EXPECT_TRUE(copy.edgesBegin()->record.edge == copy.edgesBegin());
  EXPECT_EQ(fault_of([&] { copy.edgesBegin()->record.edge->length(); }), "");
}

TEST_F(Copy, KeepsWhatStudentsStore) {
  HalfedgeMesh mesh = mesh_of(diamond());
  mesh.verticesBegin()->isNew = true;
  mesh.verticesBegin()->newPosition = 3;
  mesh.edgesBegin()->isNew = true;
  mesh.edgesBegin()->newPosition = 4;
  mesh.edgesBegin()->record.score = 5;
  HalfedgeMesh copy;
  copy = mesh;
  EXPECT_TRUE(copy.verticesBegin()->isNew);
  EXPECT_EQ(copy.verticesBegin()->newPosition.y, 3.0);
  EXPECT_TRUE(copy.edgesBegin()->isNew);
  EXPECT_EQ(copy.edgesBegin()->newPosition.y, 4.0);
  EXPECT_EQ(copy.edgesBegin()->record.score, 5.0);
}

TEST_F(Copy, LeavesDeletedElementsOutAndPointersToThemUnset) {
  HalfedgeMesh mesh = mesh_of(diamond());
  const VertexIter first = mesh.verticesBegin();
  const HalfedgeIter h = first->halfedge();
  mesh.deleteVertex(first);
  HalfedgeMesh copy = mesh;
  EXPECT_EQ(copy.nVertices(), 3U);
  const auto number = std::distance(mesh.halfedgesBegin(), h);
  EXPECT_TRUE(std::next(copy.halfedgesBegin(), number)->vertex() == VertexIter());
}

TEST_F(Copy, OfItselfChangesNothing) {
  HalfedgeMesh mesh = mesh_of(octahedron());
  const auto before = full_wiring(mesh);
  const HalfedgeMesh& same = mesh;
  mesh = same;
  EXPECT_EQ(full_wiring(mesh), before);
}

TEST_F(Copy, IsAnotherMeshToTheHandles) {
  HalfedgeMesh mesh = mesh_of(diamond());
  HalfedgeMesh copy = mesh;
  EXPECT_TRUE(copy.facesBegin() != mesh.facesBegin());
  EXPECT_EQ(fault_of([&] { copy.deleteFace(mesh.facesBegin()); }),
            sentence(FaultKind::kForeignHandle, "face handle"));
}

}  // namespace
}  // namespace meshedit
