#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

HalfedgeIter halfedgeThatLeadsTo(HalfedgeIter h) {
  HalfedgeIter before = h;
  while (before->next() != h)
    before = before->next();
  return before;
}

// Whether the faces on both sides of h have a corner in common that is no end of it. They do,
// too, where an end has no third edge: both of them follow the second one.
bool shareMoreThanTheEdge(HalfedgeIter h) {
  const HalfedgeIter t = h->twin();
  std::set<VertexIter> corners;
  for (HalfedgeIter k = h->next()->next(); k != h; k = k->next())
    corners.insert(k->vertex());
  for (HalfedgeIter k = t->next()->next(); k != t; k = k->next()) {
    if (corners.count(k->vertex()) != 0) return true;
  }
  return false;
}

// Whether the face of h touches a boundary anywhere but in its edge.
bool touchesBoundaryElsewhere(HalfedgeIter h) {
  for (HalfedgeIter k = h->next()->next(); k != h; k = k->next()) {
    if (k->vertex()->isBoundary()) return true;
  }
  return false;
}

}  // namespace
// SOLUTION END

// EXERCISE edge_dissolve: take an edge away; the faces beside it become one.
//
//      d ---- a ---- y        d ---- a ---- y
//      |      |      |        |             |
//      |  g   |   f  |        |      f      |
//      |      |      |        |             |
//      x ---- b ---- c        x ---- b ---- c
//
// If one side is outside of the surface, the face goes and its half-edges join the boundary
// loop. Mind what the edge and the face that go were the anchors of.
//
// Look first, and return std::nullopt without a change, if no surface would be left:
//   - the two faces are one already, or share more than this edge and its ends;
//   - one of the ends has no third edge;
//   - the face at a boundary touches it elsewhere, too.
std::optional<FaceIter> PolyMesh::dissolveEdge(EdgeIter e) {
  // SOLUTION BEGIN PolyMesh::dissolveEdge
  HalfedgeIter h = e->halfedge();
  HalfedgeIter t = h->twin();
  if (h->isBoundary()) std::swap(h, t);
  if (t->isBoundary() ? touchesBoundaryElsewhere(h) : shareMoreThanTheEdge(h))
    return std::nullopt;

  const FaceIter gone = h->face();
  const FaceIter left = t->face();
  for (HalfedgeIter k = h->next(); k != h; k = k->next())
    k->face() = left;
  h->vertex()->halfedge() = t->next();
  t->vertex()->halfedge() = h->next();
  left->halfedge() = h->next();
  const HalfedgeIter to_h = halfedgeThatLeadsTo(h);
  const HalfedgeIter to_t = halfedgeThatLeadsTo(t);
  to_h->next() = t->next();
  to_t->next() = h->next();
  deleteFace(gone);
  deleteHalfedge(h);
  deleteHalfedge(t);
  deleteEdge(e);
  return left;
  // SOLUTION END
}

}  // namespace meshedit
