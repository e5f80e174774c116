#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

// The half-edge that comes before h in its face. Takes as many steps as the face has corners.
HalfedgeIter previousOf(HalfedgeIter h) {
  HalfedgeIter previous = h;
  while (previous->next() != h)
    previous = previous->next();
  return previous;
}

// Whether the walk from `from` up to `end` passes the vertex.
bool passes(HalfedgeIter from, HalfedgeIter end, VertexIter vertex) {
  for (; from != end; from = from->next()) {
    if (from->vertex() == vertex) return true;
  }
  return false;
}

}  // namespace
// SOLUTION END

// EXERCISE edge_flip_polygon: turn an edge by one corner, counter-clockwise in both faces.
//
//      d ---- a ---- y        d ---- a ---- y
//      |      |      |        | `-.      f  |
//      |  g   |   f  |        |    `-.      |         before: a - b      after: d - c
//      |      |      |        |  g    `-.   |
//      x ---- b ---- c        x ---- b --`- c
//
// Nothing is created and nothing is deleted. The half-edges b-c and a-d change their face; the
// two half-edges of the edge move; the half-edges before them get another next. Which pointers
// of vertices and faces may lead somewhere wrong afterwards?
//
// Return std::nullopt, and change nothing, for a boundary edge, and where c lies in g or d in
// f: that face would visit a vertex twice.
std::optional<EdgeIter> PolyMesh::flipEdge(EdgeIter e) {
  // SOLUTION BEGIN PolyMesh::flipEdge
  if (e->isBoundary()) return std::nullopt;
  const HalfedgeIter h = e->halfedge();  // a to b, in f
  const HalfedgeIter t = h->twin();      // b to a, in g
  const HalfedgeIter bc = h->next();
  const HalfedgeIter ad = t->next();
  const HalfedgeIter after_c = bc->next();
  const HalfedgeIter after_d = ad->next();
  const VertexIter a = h->vertex();
  const VertexIter b = t->vertex();
  const VertexIter c = after_c->vertex();
  const VertexIter d = after_d->vertex();
  if (passes(after_c, h, d) || passes(after_d, t, c)) return std::nullopt;

  const FaceIter f = h->face();
  const FaceIter g = t->face();
  const HalfedgeIter to_a = previousOf(h);
  const HalfedgeIter to_b = previousOf(t);

  // f: ..., a, d, c, ...
  to_a->next() = ad;
  ad->next() = h;
  h->next() = after_c;
  ad->face() = f;
  f->halfedge() = h;
  h->vertex() = d;

  // g: ..., b, c, d, ...
  to_b->next() = bc;
  bc->next() = t;
  t->next() = after_d;
  bc->face() = g;
  g->halfedge() = t;
  t->vertex() = c;

  // The edge has left a and b.
  a->halfedge() = ad;
  b->halfedge() = bc;
  return e;
  // SOLUTION END
}

}  // namespace meshedit
