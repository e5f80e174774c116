#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

HalfedgeIter leadingTo(HalfedgeIter h) {
  HalfedgeIter before = h;
  while (before->next() != h)
    before = before->next();
  return before;
}

std::vector<HalfedgeIter> startingAt(VertexIter v) {
  std::vector<HalfedgeIter> all;
  HalfedgeIter h = v->halfedge();
  do {
    all.push_back(h);
    h = h->twin()->next();
  } while (h != v->halfedge());
  return all;
}

HalfedgeIter outsideOf(EdgeIter e) {
  return e->halfedge()->isBoundary() ? e->halfedge() : e->halfedge()->twin();
}

// Whether two vertices, one of them an end of edge e and the other one of edge f, may become
// one: no edge joins them, no face has both, and no two edges would lead to the same vertex.
bool mayMeet(VertexIter a, VertexIter b, EdgeIter e, EdgeIter f) {
  if (a == b) return true;
  std::set<VertexIter> neighbours;
  for (HalfedgeIter h : startingAt(a)) {
    if (h->edge() != e) neighbours.insert(h->twin()->vertex());
    if (h->twin()->vertex() == b) return false;
    for (HalfedgeIter k = h->next(); k != h && !h->isBoundary(); k = k->next()) {
      if (k->vertex() == b) return false;
    }
  }
  for (HalfedgeIter h : startingAt(b)) {
    if (h->edge() != f && neighbours.count(h->twin()->vertex()) != 0) return false;
  }
  return true;
}

// Makes one vertex of two. What starts at `gone` was collected before the mesh was changed.
void meet(PolyMesh& mesh, VertexIter left, VertexIter gone,
          const std::vector<HalfedgeIter>& starting_at_gone) {
  if (left == gone) return;
  left->position = 0.5 * (left->position + gone->position);
  for (HalfedgeIter h : starting_at_gone)
    h->vertex() = left;
  mesh.deleteVertex(gone);
}

}  // namespace
// SOLUTION END

// EXERCISE edge_weld: make one edge of two that lie on a boundary.
//
//      o --- b   c --- o        o ---- o ---- o
//      |     |   |     |        |      |      |
//      |   e |   | f   |        |      |      |        b meets c, and a meets d
//      |     |   |     |        |      |      |
//      o --- a   d --- o        o ---- o ---- o
//
// In its face, e starts where f ends. Two ends that meet become one vertex, in the middle. If
// both edges have an end, that stays, and is inside of the surface then.
// The half-edges outside go. What is left of their boundary loops is one loop, two, or none.
//
// Look first, and return std::nullopt without a change, if no surface would be left:
//   - one of the edges has a face on both sides, or they are the same edge;
//   - two ends that would meet are joined by an edge, or are corners of the same face.
std::optional<EdgeIter> PolyMesh::weldEdges(EdgeIter e, EdgeIter f) {
  // SOLUTION BEGIN PolyMesh::weldEdges
  if (e == f || !e->isBoundary() || !f->isBoundary()) return std::nullopt;
  const HalfedgeIter h = outsideOf(e);
  const HalfedgeIter g = outsideOf(f);
  const VertexIter b = h->vertex();
  const VertexIter a = h->twin()->vertex();
  const VertexIter d = g->vertex();
  const VertexIter c = g->twin()->vertex();
  if (!mayMeet(a, d, e, f) || !mayMeet(b, c, e, f)) return std::nullopt;

  const std::set<FaceIter> old_loops{h->face(), g->face()};
  const std::vector<HalfedgeIter> at_d = startingAt(d);
  const std::vector<HalfedgeIter> at_c = startingAt(c);
  const HalfedgeIter before_h = leadingTo(h);
  const HalfedgeIter before_g = leadingTo(g);
  std::vector<HalfedgeIter> begins;  // half-edges outside that stay, one of each loop at least
  if (before_g != h) {
    begins.push_back(h->next());
    before_g->next() = h->next();
  }
  if (before_h != g) {
    begins.push_back(g->next());
    before_h->next() = g->next();
  }
  for (HalfedgeIter begin : begins) {
    if (old_loops.count(begin->face()) == 0) continue;
    const FaceIter loop = newBoundary();
    loop->halfedge() = begin;
    HalfedgeIter k = begin;
    do {
      k->face() = loop;
      k = k->next();
    } while (k != begin);
  }

  meet(*this, a, d, at_d);
  meet(*this, b, c, at_c);
  const HalfedgeIter inside = h->twin();
  const HalfedgeIter opposite = g->twin();
  inside->twin() = opposite;
  opposite->twin() = inside;
  opposite->edge() = e;
  e->halfedge() = inside;
  a->halfedge() = inside;
  b->halfedge() = opposite;
  deleteHalfedge(h);
  deleteHalfedge(g);
  deleteEdge(f);
  for (FaceIter loop : old_loops)
    deleteBoundary(loop);
  return e;
  // SOLUTION END
}

}  // namespace meshedit
