#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

// Cuts the face of `mb`, which leaves the new vertex m for b, from m to the corner behind b.
// `to_m` comes before `mb`.
//
//        x ---- c                    x ---- c
//        |      |                    |    / |          the new face:  mb, bc, cm
//        |      |                    |  /   |          the old one:   to_m, mc, ...
//     -> m -mb- b                 -> m -mb- b
void cutCorner(PolyMesh& mesh, HalfedgeIter to_m, HalfedgeIter mb) {
  const HalfedgeIter bc = mb->next();
  const HalfedgeIter after_c = bc->next();
  const FaceIter old_face = mb->face();
  const FaceIter corner = mesh.newFace();
  const EdgeIter edge = mesh.newEdge();
  const HalfedgeIter mc = mesh.newHalfedge();
  const HalfedgeIter cm = mesh.newHalfedge();
  edge->halfedge() = mc;
  mc->setNeighbors(after_c, cm, mb->vertex(), edge, old_face);
  cm->setNeighbors(mb, mc, after_c->vertex(), edge, corner);
  to_m->next() = mc;
  bc->next() = cm;
  mb->face() = corner;
  bc->face() = corner;
  corner->halfedge() = mb;
  old_face->halfedge() = mc;
}

}  // namespace
// SOLUTION END

// EXERCISE edge_split_polygon: put a new vertex in the middle of an edge, and cut the faces on
// its sides.
//
//      d ---- a ---- y        d ---- a ---- y
//      |      |      |        |   `- |      |
//      |      |      |        |      m      |         new: m, its edges to b, c and d
//      |      |      |        |      | `-.  |
//      x ---- b ---- c        x ---- b ---- c
//
// In each face a new edge runs from m to the corner that FOLLOWS the edge there: c follows b,
// and on the other side d follows a. Faces may have any number of corners. Outside of the
// surface nothing is cut: at the boundary there is one new edge less, and one new face.
//
// Return m. Its halfedge() must lie along the old edge.
std::optional<VertexIter> PolyMesh::splitEdge(EdgeIter e) {
  // SOLUTION BEGIN PolyMesh::splitEdge
  const HalfedgeIter h = e->halfedge();  // a to b, then a to m
  const HalfedgeIter t = h->twin();      // b to a, then b to m
  const VertexIter m = newVertex();
  const EdgeIter half = newEdge();
  const HalfedgeIter mb = newHalfedge();
  const HalfedgeIter ma = newHalfedge();
  m->position = 0.5 * (h->vertex()->position + t->vertex()->position);
  m->halfedge() = mb;

  mb->setNeighbors(h->next(), t, m, half, h->face());
  ma->setNeighbors(t->next(), h, m, e, t->face());
  h->next() = mb;
  t->next() = ma;
  h->twin() = ma;
  t->twin() = mb;
  t->edge() = half;
  half->halfedge() = mb;
  e->halfedge() = h;

  if (!h->isBoundary()) cutCorner(*this, h, mb);
  if (!t->isBoundary()) cutCorner(*this, t, ma);
  return m;
  // SOLUTION END
}

}  // namespace meshedit
