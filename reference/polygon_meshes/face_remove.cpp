#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

std::vector<HalfedgeIter> roundOf(HalfedgeIter start) {
  std::vector<HalfedgeIter> all;
  HalfedgeIter h = start;
  do {
    all.push_back(h);
    h = h->next();
  } while (h != start);
  return all;
}

bool isOnBoundary(HalfedgeIter side) {
  return side->twin()->isBoundary();
}

// Whether a surface is left: some side does not lie on a boundary, and where a corner does, so
// does a side there.
bool leavesASurface(const std::vector<HalfedgeIter>& sides) {
  bool leaves = false;
  for (Size i = 0; i < sides.size(); ++i) {
    const HalfedgeIter before = sides[(i + sides.size() - 1) % sides.size()];
    const bool is_side = isOnBoundary(sides[i]) || isOnBoundary(before);
    if (sides[i]->vertex()->isBoundary() && !is_side) return false;
    leaves = leaves || !isOnBoundary(sides[i]);
  }
  return leaves;
}

}  // namespace
// SOLUTION END

// EXERCISE face_remove: take a face away; the outside takes its place.
//
//      o --- o --- o --- o        o --- o --- o --- o
//      |     |     |     |        |     |     |     |
//      o --- o --- o --- o        o --- o --- o --- o
//      |     |  f  |     |        |     |     |     |       the boundary at the bottom now
//      o --- o --- o --- o        o --- o     o --- o       runs around where f was
//
// Inside of the surface, the sides of f become a boundary loop of their own. A side that lay on
// a boundary has no face then, and goes; so does a corner between two such sides. The loop
// there grows into where f was. If f touched boundaries in several sides, loops may join or
// fall apart.
//
// Look first, and return std::nullopt without a change, if no surface would be left:
//   - the face touches a boundary in a corner, and in no side there;
//   - all of its sides lie on a boundary.
std::optional<FaceIter> PolyMesh::removeFace(FaceIter f) {
  // SOLUTION BEGIN PolyMesh::removeFace
  const std::vector<HalfedgeIter> sides = roundOf(f->halfedge());
  if (!leavesASurface(sides)) return std::nullopt;

  const Size n = sides.size();
  // Who leads to whom where the outside takes over; before anything is changed.
  std::vector<std::pair<HalfedgeIter, HalfedgeIter>> links;
  std::vector<VertexIter> gone;
  std::set<FaceIter> old_loops;
  for (Size i = 0; i < n; ++i) {
    const HalfedgeIter before = sides[(i + n - 1) % n];
    const HalfedgeIter side = sides[i];
    if (isOnBoundary(side)) old_loops.insert(side->twin()->face());
    if (isOnBoundary(before) && isOnBoundary(side)) {
      gone.push_back(side->vertex());
    } else if (isOnBoundary(side)) {
      links.emplace_back(before, side->twin()->next());
    } else if (isOnBoundary(before)) {
      links.emplace_back(roundOf(before->twin()).back(), side);
    }
  }
  for (const auto& [in, out] : links) {
    in->next() = out;
    out->vertex()->halfedge() = out;
  }
  FaceIter left;
  for (HalfedgeIter side : sides) {
    if (isOnBoundary(side) || side->face() != f) continue;
    left = newBoundary();
    left->halfedge() = side;
    for (HalfedgeIter h : roundOf(side))
      h->face() = left;
  }
  for (HalfedgeIter side : sides) {
    if (!isOnBoundary(side) || side->face() != f) continue;
    deleteHalfedge(side->twin());
    deleteEdge(side->edge());
    deleteHalfedge(side);
  }
  for (VertexIter v : gone)
    deleteVertex(v);
  for (FaceIter loop : old_loops)
    deleteBoundary(loop);
  deleteFace(f);
  return left;
  // SOLUTION END
}

}  // namespace meshedit
