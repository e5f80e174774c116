// Which pointers differ between two states of a mesh.

#include "grader/mesh/mesh_changes.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

MeshDump small_mesh() {
  MeshDump mesh;
  mesh.halfedges = {{1, 1, 0, 0, 0, 1}, {0, 0, 1, 0, kBoundaryBit, 1}};
  mesh.vertices = {{0, 1, {0, 0, 0}}, {1, 1, {1, 0, 0}}};
  mesh.edges = {{0, 1}};
  mesh.faces = {{0, 1, 0}};
  mesh.boundaries = {{1, 1, 1}};
  return mesh;
}

TEST(MeshChanges, NothingChangedIsNothingTold) {
  MeshDump moved = small_mesh();
  moved.vertices[0].position = {5, 5, 5};
  EXPECT_TRUE(find_changes(small_mesh(), moved).empty());
}

TEST(MeshChanges, EachPointerIsToldWithOldAndNew) {
  MeshDump after = small_mesh();
  after.halfedges[0].next = kUnsetRef;
  after.halfedges[1].face = 0;
  after.boundaries[0].halfedge = 1 | kDeletedBit;
  const std::vector<PointerChange> changes = find_changes(small_mesh(), after);
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].element + "." + changes[0].pointer, "h0.next");
  EXPECT_EQ(changes[0].before, "h1");
  EXPECT_EQ(changes[0].after, "unset");
  EXPECT_EQ(changes[1].element + "." + changes[1].pointer, "h1.face");
  EXPECT_EQ(changes[1].before, "b0");
  EXPECT_EQ(changes[1].after, "f0");
  EXPECT_EQ(changes[2].element, "b0");
  EXPECT_EQ(changes[2].after, "h1 (deleted)");
}

TEST(MeshChanges, NewElementsHaveNoOldAndDeletedOnesNoNewPointers) {
  MeshDump after = small_mesh();
  after.vertices.push_back({0, 1, {0, 1, 0}});
  after.edges[0].live = 0;
  const std::vector<PointerChange> changes = find_changes(small_mesh(), after);
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].element, "v2");
  EXPECT_EQ(changes[0].before, "");
  EXPECT_EQ(changes[0].after, "h0");
  EXPECT_EQ(changes[1].element, "e0");
  EXPECT_EQ(changes[1].after, "");
}

TEST(MeshChanges, ListEndsWhereItIsTold) {
  MeshDump after = small_mesh();
  for (HalfedgeRecord& h : after.halfedges)
    h.next = h.twin = h.face = kUnsetRef;
  const std::vector<PointerChange> all = find_changes(small_mesh(), after);
  ASSERT_GT(all.size(), 3U);
  for (std::size_t most = 0; most <= all.size() + 1; ++most) {
    const std::vector<PointerChange> some = find_changes(small_mesh(), after, most);
    ASSERT_EQ(some.size(), std::min(most, all.size()));
    for (std::size_t i = 0; i < some.size(); ++i) {
      EXPECT_EQ(some[i].element, all[i].element);
      EXPECT_EQ(some[i].pointer, all[i].pointer);
    }
  }
}

}  // namespace
}  // namespace meshgrade
