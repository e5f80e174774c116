#include <gtest/gtest.h>

#include <set>

#include "mesh_invariants.h"
#include "meshedit/meshedit.h"
#include "sample_meshes.h"

namespace meshedit {
namespace {

std::set<Index> ends_of(HalfedgeMesh& mesh, EdgeIter e) {
  return {number_of(mesh, e->halfedge()->vertex()),
          number_of(mesh, e->halfedge()->twin()->vertex())};
}

std::set<Index> opposite_of(HalfedgeMesh& mesh, EdgeIter e) {
  const HalfedgeIter h = e->halfedge();
  return {number_of(mesh, h->next()->next()->vertex()),
          number_of(mesh, h->twin()->next()->next()->vertex())};
}

TEST(EdgeFlip, JoinsTheVerticesThatWereOpposite) {
  HalfedgeMesh mesh = mesh_of(diamond());
  const EdgeIter e = edge_between(mesh, 1, 2);
  EXPECT_TRUE(mesh.flipEdge(e) == e);
  EXPECT_EQ(ends_of(mesh, e), (std::set<Index>{0, 3}));
  EXPECT_EQ(opposite_of(mesh, e), (std::set<Index>{1, 2}));
  EXPECT_EQ(broken_rule(mesh), "");
  for (FaceIter f = mesh.facesBegin(); f != mesh.facesEnd(); ++f) {
    EXPECT_EQ(f->normal().z, 1.0);
  }
}

// All rules but `simple` hold after a flip even where the two vertices are joined already, as
// in a tetrahedron: half-edges do not mind two edges between the same vertices.
TEST(EdgeFlip, KeepsTheRulesAndTheCountsOnEveryInnerEdge) {
  for (const Polygons& polygons : all_triangle_meshes()) {
    const HalfedgeMesh original = mesh_of(polygons);
    for (Index i = 0; i < original.nEdges(); ++i) {
      HalfedgeMesh mesh = original;
      const EdgeIter e = std::next(mesh.edgesBegin(), static_cast<std::ptrdiff_t>(i));
      if (e->isBoundary()) continue;
      const std::set<Index> ends = ends_of(mesh, e);
      const std::set<Index> opposite = opposite_of(mesh, e);
      if (opposite.size() < 2) continue;
      EXPECT_TRUE(mesh.flipEdge(e) == e);
      EXPECT_EQ(broken_rule(mesh), "");
      EXPECT_EQ(ends_of(mesh, e), opposite);
      EXPECT_EQ(opposite_of(mesh, e), ends);
      EXPECT_EQ(mesh.nHalfedges(), original.nHalfedges());
      EXPECT_EQ(mesh.nEdges(), original.nEdges());
      EXPECT_EQ(mesh.nFaces(), original.nFaces());
    }
  }
}

// A flip is a quarter turn of the edge, so four of them bring every pointer between half-edges
// back.
TEST(EdgeFlip, FourQuarterTurnsComeBack) {
  const HalfedgeMesh original = mesh_of(torus(5, 4));
  for (Index i = 0; i < original.nEdges(); ++i) {
    HalfedgeMesh mesh = original;
    const EdgeIter e = std::next(mesh.edgesBegin(), static_cast<std::ptrdiff_t>(i));
    for (int turn = 1; turn <= 4; ++turn) {
      mesh.flipEdge(e);
      EXPECT_EQ(broken_rule(mesh), "");
      EXPECT_EQ(wiring(mesh) == wiring(original), turn == 4);
    }
  }
}

// Six flips are a turn and a half: the same two triangles, with the edge the other way round.
TEST(EdgeFlip, SixQuarterTurnsTurnTheEdgeAround) {
  HalfedgeMesh mesh = mesh_of(octahedron());
  const EdgeIter e = mesh.edgesBegin();
  const VertexIter start = e->halfedge()->vertex();
  const VertexIter end = e->halfedge()->twin()->vertex();
  for (int i = 0; i < 6; ++i) {
    mesh.flipEdge(e);
  }
  EXPECT_TRUE(e->halfedge()->vertex() == end);
  EXPECT_TRUE(e->halfedge()->twin()->vertex() == start);
  EXPECT_EQ(broken_rule(mesh), "");
}

TEST(EdgeFlip, BoundaryEdgeIsLeftAlone) {
  for (const Polygons& polygons : {triangle(), diamond(), sheet(3, 2), frame()}) {
    HalfedgeMesh mesh = mesh_of(polygons);
    for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
      if (!e->isBoundary()) continue;
      for (int side = 0; side < 2; ++side) {
        e->halfedge() = e->halfedge()->twin();
        const auto before = full_wiring(mesh);
        mesh.flipEdge(e);
        EXPECT_EQ(full_wiring(mesh), before);
      }
    }
  }
}

}  // namespace
}  // namespace meshedit
