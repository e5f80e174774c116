#include "grader/judge/operation_model.h"

#include <gtest/gtest.h>

#include "grader/mesh/mesh_rules.h"
#include "tests/support/right_answers.h"

namespace meshgrade {
namespace {

/// Calls `check(file, mesh, edge)` for every edge of every triangle mesh file.
template <class Check>
void for_every_edge(Check check) {
  for (const std::string& file : triangle_mesh_files()) {
    const MeshDump mesh = sample_dump(file);
    for (Ref e = 0; e < mesh.edges.size(); ++e)
      check(file + " " + edge_name(e), mesh, e);
  }
}

bool can_flip(const MeshDump& mesh, Ref e) {
  if (is_boundary_edge(mesh, e)) return false;
  const Diamond d = diamond_of(mesh, e);
  return d.a != d.d && find_edge(mesh, d.a, d.d) == kUnsetRef;
}

TEST(OperationModel, FlippedEdgeJoinsTheOppositeCornersAndAllRulesHold) {
  std::size_t flips = 0;
  for_every_edge([&](const std::string& where, MeshDump mesh, Ref e) {
    if (!can_flip(mesh, e)) return;
    const Diamond before = diamond_of(mesh, e);
    const Counts counts = count(mesh);
    model_flip(mesh, e);
    EXPECT_TRUE(find_broken_rules(mesh).empty()) << where;
    EXPECT_EQ(count(mesh), counts) << where;
    EXPECT_EQ(find_edge(mesh, before.a, before.d), e) << where;
    EXPECT_EQ(find_edge(mesh, before.b, before.c), kUnsetRef) << where;
    ++flips;
  });
  EXPECT_GT(flips, 500U);
}

TEST(OperationModel, FourFlipsAreTheIdentityOnHalfedges) {
  for_every_edge([&](const std::string& where, MeshDump mesh, Ref e) {
    if (!can_flip(mesh, e)) return;
    const MeshDump before = mesh;
    for (int i = 0; i < 4; ++i)
      model_flip(mesh, e);
    for (Ref h = 0; h < mesh.halfedges.size(); ++h) {
      const HalfedgeRecord& a = before.halfedges[h];
      const HalfedgeRecord& b = mesh.halfedges[h];
      EXPECT_TRUE(a.next == b.next && a.twin == b.twin && a.vertex == b.vertex &&
                  a.edge == b.edge && a.face == b.face)
          << where << " " << halfedge_name(h);
    }
  });
}

TEST(OperationModel, SplitAddsAMidpointAndAllRulesHold) {
  for_every_edge([&](const std::string& where, MeshDump mesh, Ref e) {
    const Diamond d = diamond_of(mesh, e);
    const bool boundary = is_boundary_edge(mesh, e);
    const Counts before = count(mesh);
    const Ref m = model_split(mesh, e);
    const Counts after = count(mesh);
    EXPECT_TRUE(find_broken_rules(mesh).empty()) << where;
    EXPECT_EQ(after.vertices, before.vertices + 1) << where;
    EXPECT_EQ(after.edges, before.edges + (boundary ? 2 : 3)) << where;
    EXPECT_EQ(after.faces, before.faces + (boundary ? 1 : 2)) << where;
    EXPECT_EQ(after.boundaries, before.boundaries) << where;
    for (Ref corner : {d.a, d.b, d.c})
      EXPECT_NE(find_edge(mesh, m, corner), kUnsetRef) << where;
    EXPECT_EQ(d.d == kUnsetRef, boundary) << where;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(mesh.vertices[m].position[i],
                0.5 * (mesh.vertices[d.b].position[i] + mesh.vertices[d.c].position[i]));
    }
  });
}

TEST(OperationModel, SplitIsUndoneByNothingButKeepsEulersNumber) {
  MeshDump mesh = sample_dump("double_torus.obj");
  const auto euler = [&] {
    const Counts c = count(mesh);
    return static_cast<int>(c.vertices) - static_cast<int>(c.edges) + static_cast<int>(c.faces);
  };
  EXPECT_EQ(euler(), -2);  // 2 - 2 * genus
  for (Ref e = 0; e < 20; ++e)
    model_split(mesh, 7 * e);
  EXPECT_EQ(euler(), -2);
}

}  // namespace
}  // namespace meshgrade
