#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

HalfedgeIter oneBefore(HalfedgeIter h) {
  HalfedgeIter before = h;
  while (before->next() != h)
    before = before->next();
  return before;
}

std::vector<HalfedgeIter> around(HalfedgeIter start) {
  std::vector<HalfedgeIter> all;
  HalfedgeIter h = start;
  do {
    all.push_back(h);
    h = h->next();
  } while (h != start);
  return all;
}

// The half-edges that leave the corners of a face for vertices that are none of them.
std::vector<HalfedgeIter> leavingFace(const std::vector<HalfedgeIter>& sides) {
  std::set<VertexIter> corners;
  for (HalfedgeIter side : sides)
    corners.insert(side->vertex());
  std::vector<HalfedgeIter> all;
  for (HalfedgeIter side : sides) {
    HalfedgeIter h = side;
    do {
      if (corners.count(h->twin()->vertex()) == 0) all.push_back(h);
      h = h->twin()->next();
    } while (h != side);
  }
  return all;
}

// How the face around h meets some corners: how often it comes to them, how many vertices it
// has besides, and whether it joins two of them by an edge that is no side of `f`.
struct Meeting {
  Size visits = 0;
  Size others = 0;
  VertexIter other;
  bool is_joined = false;
};

Meeting meetingOf(HalfedgeIter start, FaceIter f, const std::set<VertexIter>& corners) {
  Meeting meeting;
  for (HalfedgeIter h : around(start)) {
    const bool from = corners.count(h->vertex()) != 0;
    const bool to = corners.count(h->twin()->vertex()) != 0;
    if (from && !to) ++meeting.visits;
    if (from && to && h->twin()->face() != f) meeting.is_joined = true;
    if (from) continue;
    ++meeting.others;
    meeting.other = h->vertex();
  }
  return meeting;
}

// Whether the faces around allow it: each visits the new vertex once, no vertex is left with
// one edge, and no two edges join the new vertex to the same one.
bool doNeighboursAllow(FaceIter f, const std::vector<HalfedgeIter>& sides) {
  std::set<VertexIter> corners;
  for (HalfedgeIter side : sides)
    corners.insert(side->vertex());
  std::set<FaceIter> seen{f};
  std::map<VertexIter, Size> vanishing;
  const std::vector<HalfedgeIter> leaving = leavingFace(sides);
  if (leaving.empty()) return false;
  for (HalfedgeIter h : leaving) {
    for (HalfedgeIter one : {h, h->twin()}) {
      if (one->isBoundary() || !seen.insert(one->face()).second) continue;
      const Meeting meeting = meetingOf(one, f, corners);
      if (meeting.visits != 1 || meeting.is_joined) return false;
      if (meeting.others == 1) ++vanishing[meeting.other];
    }
  }
  std::map<VertexIter, Size> edges;
  for (HalfedgeIter h : leaving)
    ++edges[h->twin()->vertex()];
  for (const auto& [vertex, n] : edges) {
    Size degree = 0;
    for (HalfedgeIter h = vertex->halfedge(); degree == 0 || h != vertex->halfedge();
         h = h->twin()->next())
      ++degree;
    if (degree < 2 + vanishing[vertex] || n > 1 + vanishing[vertex]) return false;
  }
  return true;
}

// Whether the face touches a boundary in one place at most, and leaves it three edges.
bool doesBoundaryAllow(const std::vector<HalfedgeIter>& sides) {
  Size corners = 0;
  Size on_boundary = 0;
  HalfedgeIter outside;
  for (HalfedgeIter side : sides) {
    if (side->vertex()->isBoundary()) ++corners;
    if (!side->twin()->isBoundary()) continue;
    ++on_boundary;
    outside = side->twin();
  }
  if (corners > on_boundary + 1) return false;
  return on_boundary == 0 || around(outside).size() >= on_boundary + 3;
}

// Makes one edge of the two sides that are left of a face.
void closeUp(PolyMesh& mesh, HalfedgeIter side) {
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

// EXERCISE face_collapse: shrink a face to one vertex, at the mean of its corners.
//
//      o ----- o ----- o         o ----- o ----- o
//      |       |       |         |       |       |
//      |   p3 --- p2   |         |       |       |
//      |   |   f  |    |         |       |       |
//      o --|      | -- o         o ----- m ----- o
//      |   p0 --- p1   |         |       |       |
//      |       |       |         |       |       |
//      o ----- o ----- o         o ----- o ----- o
//
// A face beside it loses a corner for each side that the two share. A triangle with such a side
// vanishes: its two other sides become one edge.
//
// Look first, and return std::nullopt without a change, if no surface would be left:
//   - the face touches a boundary in two places, or nothing but boundaries;
//   - another face has two of its corners, and not the side between them;
//   - a triangle would vanish whose third corner is left with one edge;
//   - a boundary would be left with two edges.
std::optional<VertexIter> PolyMesh::collapseFace(FaceIter f) {
  // SOLUTION BEGIN PolyMesh::collapseFace
  const std::vector<HalfedgeIter> sides = around(f->halfedge());
  if (!doesBoundaryAllow(sides) || !doNeighboursAllow(f, sides)) return std::nullopt;

  const VertexIter left = sides[0]->vertex();
  Vector3D sum(0, 0, 0);
  for (HalfedgeIter side : sides)
    sum += side->vertex()->position;
  left->position = sum / static_cast<double>(sides.size());
  std::set<VertexIter> gone;
  for (HalfedgeIter side : sides)
    gone.insert(side->vertex());
  gone.erase(left);
  for (HalfedgeIter h : leavingFace(sides)) {
    h->vertex() = left;
    left->halfedge() = h;
  }
  std::set<FaceIter> beside;
  for (HalfedgeIter side : sides) {
    const HalfedgeIter t = side->twin();
    oneBefore(t)->next() = t->next();
    t->face()->halfedge() = t->next();
    beside.insert(t->face());
  }
  for (HalfedgeIter side : sides) {
    deleteHalfedge(side->twin());
    deleteEdge(side->edge());
    deleteHalfedge(side);
  }
  deleteFace(f);
  for (VertexIter v : gone)
    deleteVertex(v);
  for (FaceIter face : beside) {
    if (around(face->halfedge()).size() == 2) closeUp(*this, face->halfedge());
  }
  return left;
  // SOLUTION END
}

}  // namespace meshedit
