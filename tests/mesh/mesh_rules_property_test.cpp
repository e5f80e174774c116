// What holds for every damage, not only for the ones that somebody thought of.

#include <gtest/gtest.h>

#include "grader/base/random.h"
#include "grader/mesh/mesh_rules.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

/// Every reference of a mesh, with the number of elements that it may lead to and whether a
/// change to another right element may leave a right mesh.
struct Pointer {
  Ref* ref;
  std::size_t targets;
  bool is_anchor;
};

std::vector<Pointer> all_pointers(MeshDump& mesh) {
  std::vector<Pointer> pointers;
  const std::size_t n = mesh.halfedges.size();
  for (HalfedgeRecord& h : mesh.halfedges) {
    pointers.push_back({&h.next, n, false});
    pointers.push_back({&h.twin, n, false});
    pointers.push_back({&h.vertex, mesh.vertices.size(), false});
    pointers.push_back({&h.edge, mesh.edges.size(), false});
    pointers.push_back({&h.face, mesh.faces.size(), false});
  }
  for (VertexRecord& v : mesh.vertices)
    pointers.push_back({&v.halfedge, n, true});
  for (EdgeRecord& e : mesh.edges)
    pointers.push_back({&e.halfedge, n, true});
  for (auto* list : {&mesh.faces, &mesh.boundaries}) {
    for (FaceRecord& f : *list)
      pointers.push_back({&f.halfedge, n, true});
  }
  return pointers;
}

/// Anchors are right by their definition, without the checker.
bool anchors_are_right(const MeshDump& mesh) {
  for (Ref v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.halfedges[mesh.vertices[v].halfedge].vertex != v) return false;
  }
  for (Ref e = 0; e < mesh.edges.size(); ++e) {
    if (mesh.halfedges[mesh.edges[e].halfedge].edge != e) return false;
  }
  for (Ref f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.halfedges[mesh.faces[f].halfedge].face != f) return false;
  }
  for (Ref b = 0; b < mesh.boundaries.size(); ++b) {
    if (mesh.halfedges[mesh.boundaries[b].halfedge].face != (b | kBoundaryBit)) return false;
  }
  return true;
}

TEST(MeshRulesProperty, EverySinglePointerToAnotherLiveElementIsNoticedOrStillRight) {
  for (const char* file :
       {"tetrahedron.obj", "two_triangles.obj", "fan.obj", "octahedron.off"}) {
    MeshDump mesh = sample_dump(file);
    std::size_t noticed = 0;
    for (const Pointer& pointer : all_pointers(mesh)) {
      const Ref right = *pointer.ref;
      for (Ref wrong = 0; wrong < pointer.targets; ++wrong) {
        if (wrong == right) continue;
        *pointer.ref = wrong;
        const bool clean = find_broken_rules(mesh).empty();
        EXPECT_EQ(clean, pointer.is_anchor && anchors_are_right(mesh)) << file;
        noticed += clean ? 0 : 1;
      }
      *pointer.ref = right;
    }
    EXPECT_GT(noticed, 300U) << file;
  }
}

Ref random_ref(Random& random, std::size_t n) {
  const Ref special[] = {kUnsetRef,
                         kPastEndRef,
                         kForeignRef,
                         kDeletedBit,
                         kBoundaryBit,
                         kBoundaryBit | 5U,
                         kDeletedBit | kBoundaryBit,
                         0x3FFFFFFFU};
  if (random.below(3) == 0) return special[random.below(8)];
  return random.below(static_cast<std::uint32_t>(2 * n));
}

TEST(MeshRulesProperty, AnyDamageIsSurvived) {
  Random random(6, "damage");
  for (const char* file : {"grid_4x4.obj", "icosahedron.obj", "single_triangle.obj"}) {
    const MeshDump right = sample_dump(file);
    for (int round = 0; round < 1500; ++round) {
      MeshDump mesh = right;
      std::vector<Pointer> pointers = all_pointers(mesh);
      for (std::uint32_t i = 1 + random.below(20); i > 0; --i) {
        const Pointer& p = pointers[random.below(static_cast<std::uint32_t>(pointers.size()))];
        *p.ref = random_ref(random, p.targets);
      }
      if (random.below(4) == 0)
        mesh.halfedges.resize(random.below(static_cast<std::uint32_t>(mesh.halfedges.size())));
      if (random.below(4) == 0 && !mesh.vertices.empty()) mesh.vertices.pop_back();
      if (random.below(4) == 0) mesh.boundaries.clear();
      for (const RuleBreak& b : find_broken_rules(mesh))
        EXPECT_FALSE(rule_meaning(b.rule).empty());
    }
  }
}

TEST(MeshRulesProperty, EmptyMeshBreaksNone) {
  EXPECT_TRUE(find_broken_rules(MeshDump{}).empty());
}

}  // namespace
}  // namespace meshgrade
