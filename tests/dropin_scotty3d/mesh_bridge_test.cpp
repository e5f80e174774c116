// Between our mesh and that of Scotty3D homework: what lives keeps its place, what is new comes
// last, and pointers that lead to no element are told as what they are.

#include "dropin_scotty3d/detail/mesh_bridge.h"

#include <gtest/gtest.h>

#include <limits>

#include "dropin_scotty3d/mesh_access.h"
#include "grader/base/wire.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"

namespace meshgrade {
namespace {

using MeshBridge =
    meshedit::detail::scotty3d::MeshBridge<meshedit::detail::scotty3d::MeshAccess>;

/// Two squares side by side; positions that float cannot hold.
PolygonMesh two_squares() {
  PolygonMesh mesh;
  for (double y : {0.1, 1.1}) {
    for (double x : {0.1, 1.1, 2.1})
      mesh.positions.push_back({x, y, 0.1});
  }
  mesh.polygons = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  return mesh;
}

/// Our mesh before and after `change` was done to theirs.
template <class Change>
std::pair<MeshDump, MeshDump> change(Change change_theirs) {
  meshedit::HalfedgeMesh ours;
  build_mesh(two_squares(), ours);
  std::pair<MeshDump, MeshDump> dumps;
  dumps.first = dump_mesh(ours);
  Halfedge_Mesh theirs;
  MeshBridge bridge(ours, theirs);
  change_theirs(theirs);
  bridge.write_back();
  dumps.second = dump_mesh(ours);
  return dumps;
}

TEST(Scotty3dBridge, MakesTheSameMesh) {
  meshedit::HalfedgeMesh ours;
  build_mesh(two_squares(), ours);
  Halfedge_Mesh theirs;
  const MeshBridge bridge(ours, theirs);
  EXPECT_EQ(theirs.vertices.size(), 6U);
  EXPECT_EQ(theirs.edges.size(), 7U);
  EXPECT_EQ(theirs.faces.size(), 3U);
  EXPECT_EQ(theirs.halfedges.size(), 14U);
  EXPECT_EQ(theirs.n_boundaries(), 1U);
  EXPECT_FALSE(theirs.validate());
  EXPECT_EQ(theirs.vertices.begin()->position, Vec3(0.1f, 0.1f, 0.1f));
}

TEST(Scotty3dBridge, ChangesNothingThatWasNotChanged) {
  const auto [before, after] = change([](Halfedge_Mesh& /*theirs*/) {});
  EXPECT_EQ(to_wire(before), to_wire(after));
}

TEST(Scotty3dBridge, TakesChangedPositionsAsTheyAre) {
  const auto [before, after] = change([](Halfedge_Mesh& theirs) {
    theirs.vertices.begin()->position = Vec3(5.0f, 0.25f, -1.0f);
    std::next(theirs.vertices.begin())->position.x = std::numeric_limits<float>::quiet_NaN();
  });
  EXPECT_EQ(after.vertices[0].position, (Point3{5.0, 0.25, -1.0}));
  EXPECT_TRUE(std::isnan(after.vertices[1].position[0]));
  EXPECT_EQ(after.vertices[2].position, before.vertices[2].position);
}

TEST(Scotty3dBridge, DeletesWhatWasErasedAndTellsWhoPointsThere) {
  const auto [before, after] = change([](Halfedge_Mesh& theirs) {
    theirs.erase_edge(theirs.edges.begin());
    theirs.erase_vertex(std::next(theirs.vertices.begin()));
  });
  EXPECT_EQ(after.edges[0].live, 0U);
  EXPECT_EQ(after.vertices[1].live, 0U);
  EXPECT_EQ(count(after).edges, 6U);
  const Ref h = before.edges[0].halfedge;
  EXPECT_EQ(after.halfedges[h].edge, 0U | kDeletedBit);
}

TEST(Scotty3dBridge, PutsNewElementsLastAlsoInPlacesThatWereFree) {
  const auto [before, after] = change([](Halfedge_Mesh& theirs) {
    const Halfedge_Mesh::FaceRef old = theirs.faces.begin();
    const Halfedge_Mesh::HalfedgeRef h = old->halfedge;
    theirs.erase_face(old);
    const Halfedge_Mesh::FaceRef made = theirs.emplace_face();
    made->halfedge = h;
    Halfedge_Mesh::HalfedgeRef k = h;
    do {
      k->face = made;
      k = k->next;
    } while (k != h);
    theirs.emplace_vertex()->position = Vec3(7.0f, 7.0f, 7.0f);
  });
  ASSERT_EQ(after.faces.size(), 3U);
  EXPECT_EQ(after.faces[0].live, 0U);
  EXPECT_EQ(after.faces[2].live, 1U);
  EXPECT_EQ(after.halfedges[before.faces[0].halfedge].face, 2U);
  ASSERT_EQ(after.vertices.size(), 7U);
  EXPECT_EQ(after.vertices[6].position[0], 7.0);
  EXPECT_EQ(after.vertices[6].halfedge, kUnsetRef);
}

TEST(Scotty3dBridge, AFaceThatBecomesABoundaryIsABoundaryLoop) {
  const auto [before, after] =
      change([](Halfedge_Mesh& theirs) { theirs.faces.begin()->boundary = true; });
  EXPECT_EQ(before.boundaries.size(), 1U);
  EXPECT_EQ(after.faces[0].live, 0U);
  ASSERT_EQ(after.boundaries.size(), 2U);
  EXPECT_EQ(after.boundaries[1].is_boundary, 1U);
  EXPECT_EQ(after.halfedges[before.faces[0].halfedge].face, 1U | kBoundaryBit);
}

TEST(Scotty3dBridge, AnElementOfAnotherMeshIsForeign) {
  Halfedge_Mesh other = Halfedge_Mesh::cube(1.0f);
  const auto [before, after] = change([&](Halfedge_Mesh& theirs) {
    theirs.halfedges.begin()->face = other.faces.begin();
    theirs.halfedges.begin()->edge = Halfedge_Mesh::EdgeRef();
  });
  EXPECT_EQ(after.halfedges[0].face, kForeignRef);
  EXPECT_EQ(after.halfedges[0].edge, kUnsetRef);
}

TEST(Scotty3dBridge, WhatIsMadeAndErasedAgainIsADeletedElement) {
  const auto [before, after] = change([](Halfedge_Mesh& theirs) {
    const Halfedge_Mesh::FaceRef scratch = theirs.emplace_face();
    theirs.erase_face(scratch);
    theirs.halfedges.begin()->face = scratch;
  });
  ASSERT_EQ(after.faces.size(), before.faces.size() + 1);
  EXPECT_EQ(after.halfedges[0].face, static_cast<Ref>(before.faces.size()) | kDeletedBit);
}

TEST(Scotty3dBridge, UsesNoSteps) {
  meshedit::HalfedgeMesh ours;
  build_mesh(two_squares(), ours);
  meshedit::detail::steps_left = 0;
  Halfedge_Mesh theirs;
  MeshBridge bridge(ours, theirs);
  bridge.write_back();
  EXPECT_EQ(meshedit::detail::steps_left, 0);
  meshedit::detail::steps_left = INT64_MAX;
}

}  // namespace
}  // namespace meshgrade
