#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

HalfedgeIter halfedgeBefore(HalfedgeIter h) {
  HalfedgeIter before = h;
  while (before->next() != h)
    before = before->next();
  return before;
}

Size cornersOf(HalfedgeIter start) {
  Size n = 0;
  HalfedgeIter h = start;
  do {
    ++n;
    h = h->next();
  } while (h != start);
  return n;
}

std::vector<HalfedgeIter> leaving(VertexIter v) {
  std::vector<HalfedgeIter> all;
  HalfedgeIter h = v->halfedge();
  do {
    all.push_back(h);
    h = h->twin()->next();
  } while (h != v->halfedge());
  return all;
}

// Whether one side of an edge allows a collapse: where a triangle vanishes, its third corner
// keeps two edges. Where that has two edges only, both of them may lie on a boundary.
bool isSideFine(HalfedgeIter h) {
  if (cornersOf(h) > 3) return true;
  return !h->isBoundary() && leaving(h->next()->next()->vertex()).size() >= 3;
}

// Whether a face other than the two beside the edge of h would visit the new vertex twice, or
// two edges would join it to the same one.
bool touchElsewhere(HalfedgeIter h) {
  const HalfedgeIter t = h->twin();
  const VertexIter b = t->vertex();
  std::set<VertexIter> apexes;  // of triangles beside the edge
  for (HalfedgeIter side : {h, t}) {
    if (cornersOf(side) == 3) apexes.insert(side->next()->next()->vertex());
  }
  std::set<VertexIter> neighbours_of_b;
  for (HalfedgeIter k : leaving(b))
    neighbours_of_b.insert(k->twin()->vertex());
  for (HalfedgeIter k : leaving(h->vertex())) {
    const VertexIter neighbour = k->twin()->vertex();
    if (neighbours_of_b.count(neighbour) != 0 && apexes.count(neighbour) == 0) return true;
    if (k->face() == h->face() || k->face() == t->face() || k->isBoundary()) continue;
    for (HalfedgeIter corner = k->next(); corner != k; corner = corner->next()) {
      if (corner->vertex() == b) return true;
    }
  }
  return false;
}

// Makes one edge of the two sides that are left of a triangle: `side` and the next one.
void zip(PolyMesh& mesh, HalfedgeIter side) {
  const HalfedgeIter other = side->next();
  const HalfedgeIter outer = side->twin();         // to where `side` starts
  const HalfedgeIter other_outer = other->twin();  // from there
  outer->twin() = other_outer;
  other_outer->twin() = outer;
  other_outer->edge() = side->edge();
  side->edge()->halfedge() = outer;
  outer->vertex()->halfedge() = outer;
  other_outer->vertex()->halfedge() = other_outer;
  mesh.deleteEdge(other->edge());
  mesh.deleteFace(side->face());
  mesh.deleteHalfedge(side);
  mesh.deleteHalfedge(other);
}

}  // namespace
// SOLUTION END

// EXERCISE edge_collapse: shrink an edge to one vertex, in its middle.
//
//           c                     c                   d --- a --- y         d ------- y
//         /   \                   |                   |     |     |          \       /
//       a ----- b                 v                   |     |     |            \   /
//         \   /                   |                   |     |     |              v
//           d                     d                   x --- b --- z         x --'  `-- z
//
// A triangle beside the edge vanishes: its two other sides become one edge. A larger face only
// loses a corner. What the vanished elements anchored needs another anchor, and every half-edge
// that left b starts at the vertex that is left.
//
// Look first, and return std::nullopt without a change, if no surface would be left:
//   - both ends lie on a boundary, and the edge does not;
//   - another face than those beside the edge has both ends as corners;
//   - a triangle would vanish whose third corner has no third edge;
//   - a boundary of three edges would lose one.
std::optional<VertexIter> PolyMesh::collapseEdge(EdgeIter e) {
  // SOLUTION BEGIN PolyMesh::collapseEdge
  const HalfedgeIter h = e->halfedge();
  const HalfedgeIter t = h->twin();
  const VertexIter a = h->vertex();
  const VertexIter b = t->vertex();
  if (a->isBoundary() && b->isBoundary() && !e->isBoundary()) return std::nullopt;
  if (!isSideFine(h) || !isSideFine(t) || touchElsewhere(h)) return std::nullopt;

  a->position = 0.5 * (a->position + b->position);
  for (HalfedgeIter k : leaving(b))
    k->vertex() = a;
  a->halfedge() = h->next();
  for (HalfedgeIter side : {h, t}) {
    halfedgeBefore(side)->next() = side->next();
    side->face()->halfedge() = side->next();
  }
  for (HalfedgeIter side : {h, t}) {
    if (cornersOf(side->next()) == 2) zip(*this, side->next());
  }
  deleteHalfedge(h);
  deleteHalfedge(t);
  deleteEdge(e);
  deleteVertex(b);
  return a;
  // SOLUTION END
}

}  // namespace meshedit
