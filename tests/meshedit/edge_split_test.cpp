#include <gtest/gtest.h>

#include <vector>

#include "mesh_invariants.h"
#include "meshedit/meshedit.h"
#include "sample_meshes.h"

namespace meshedit {
namespace {

struct Counts {
  Size vertices, edges, faces, boundaries, halfedges;

  explicit Counts(const HalfedgeMesh& mesh)
      : vertices(mesh.nVertices()),
        edges(mesh.nEdges()),
        faces(mesh.nFaces()),
        boundaries(mesh.nBoundaries()),
        halfedges(mesh.nHalfedges()) {}
};

EdgeIter edge_at(HalfedgeMesh& mesh, Index i) {
  return std::next(mesh.edgesBegin(), static_cast<std::ptrdiff_t>(i));
}

/// Splits every edge of every sample mesh, each in a mesh of its own, and calls
/// `check(original, mesh, e, m)`.
template <class Check>
void for_every_split(Check check) {
  for (const Polygons& polygons : all_triangle_meshes()) {
    HalfedgeMesh original = mesh_of(polygons);
    for (Index i = 0; i < original.nEdges(); ++i) {
      HalfedgeMesh mesh = original;
      const EdgeIter e = edge_at(mesh, i);
      const VertexIter m = mesh.splitEdge(e);
      check(original, mesh, edge_at(original, i), m);
    }
  }
}

TEST(EdgeSplit, KeepsEveryRuleInsideAndOnTheBoundary) {
  for_every_split([](HalfedgeMesh&, const HalfedgeMesh& mesh, EdgeIter, VertexIter) {
    EXPECT_EQ(broken_rule(mesh), "");
  });
}

TEST(EdgeSplit, AddsTheElementsOfOneOrTwoCutTriangles) {
  for_every_split([](HalfedgeMesh& original, HalfedgeMesh& mesh, EdgeIter e, VertexIter) {
    const Counts old(original);
    const Counts now(mesh);
    const Size cut = e->isBoundary() ? 1 : 2;
    EXPECT_EQ(now.vertices, old.vertices + 1);
    EXPECT_EQ(now.edges, old.edges + 1 + cut);
    EXPECT_EQ(now.faces, old.faces + cut);
    EXPECT_EQ(now.halfedges, old.halfedges + 2 + 2 * cut);
    EXPECT_EQ(now.boundaries, old.boundaries);
  });
}

TEST(EdgeSplit, PutsTheNewVertexInTheMiddle) {
  for_every_split([](HalfedgeMesh&, HalfedgeMesh& mesh, EdgeIter e, VertexIter m) {
    const Vector3D a = e->halfedge()->vertex()->position;
    const Vector3D b = e->halfedge()->twin()->vertex()->position;
    EXPECT_NEAR((m->position - 0.5 * (a + b)).norm(), 0.0, 1e-15);
    EXPECT_EQ(m->degree(), e->isBoundary() ? 2U : 4U);
    EXPECT_EQ(m->isBoundary(), e->isBoundary());
    EXPECT_TRUE(m == --mesh.verticesEnd());
  });
}

TEST(EdgeSplit, NewVertexNamesAHalfOfTheOldEdge) {
  for_every_split([](HalfedgeMesh& original, HalfedgeMesh& mesh, EdgeIter e, VertexIter m) {
    const Index other = number_of(mesh, m->halfedge()->twin()->vertex());
    EXPECT_TRUE(other == number_of(original, e->halfedge()->vertex()) ||
                other == number_of(original, e->halfedge()->twin()->vertex()));
  });
}

TEST(EdgeSplit, MarksTheNewVertexAndTheEdgesToTheSides) {
  for_every_split([](HalfedgeMesh&, HalfedgeMesh& mesh, EdgeIter old, VertexIter m) {
    Size marked = 0;
    for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
      if (e->isNew) ++marked;
    }
    EXPECT_EQ(marked, old->isBoundary() ? 1U : 2U);
    EXPECT_TRUE(m->isNew);
    EXPECT_FALSE(m->halfedge()->edge()->isNew);
  });
}

TEST(EdgeSplit, LeavesTheDegreesOfTheEndsAndRaisesThoseOpposite) {
  HalfedgeMesh mesh = mesh_of(octahedron());
  const HalfedgeIter h = mesh.edgesBegin()->halfedge();
  const VertexIter ends[] = {h->vertex(), h->twin()->vertex()};
  const VertexIter opposite[] = {h->next()->next()->vertex(),
                                 h->twin()->next()->next()->vertex()};
  mesh.splitEdge(mesh.edgesBegin());
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(ends[i]->degree(), 4U);
    EXPECT_EQ(opposite[i]->degree(), 5U);
  }
}

TEST(EdgeSplit, DoesNotTurnTheSurfaceOver) {
  HalfedgeMesh mesh = mesh_of(sheet(3, 3));
  const Size edges = mesh.nEdges();
  for (Index i = 0; i < edges; ++i) {
    mesh.splitEdge(edge_at(mesh, i));
  }
  EXPECT_EQ(broken_rule(mesh), "");
  for (FaceIter f = mesh.facesBegin(); f != mesh.facesEnd(); ++f) {
    EXPECT_NEAR(f->normal().z, 1.0, 1e-15);
  }
}

TEST(EdgeSplit, BoundaryLoopGrowsByOneHalfedgeWhicheverSideTheEdgeNames) {
  for (int side = 0; side < 2; ++side) {
    HalfedgeMesh mesh = mesh_of(triangle());
    const EdgeIter e = mesh.edgesBegin();
    if (side == 1) e->halfedge() = e->halfedge()->twin();
    mesh.splitEdge(e);
    EXPECT_EQ(broken_rule(mesh), "");
    EXPECT_EQ(mesh.boundariesBegin()->degree(), 4U);
    EXPECT_EQ(mesh.nFaces(), 2U);
  }
}

}  // namespace
}  // namespace meshedit
