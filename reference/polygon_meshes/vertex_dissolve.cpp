#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

// The half-edges that leave v, clockwise; on a boundary, first the one outside.
std::vector<HalfedgeIter> spokesOf(VertexIter v) {
  std::vector<HalfedgeIter> spokes;
  HalfedgeIter h = v->halfedge();
  do {
    spokes.push_back(h);
    h = h->twin()->next();
  } while (h != v->halfedge());
  for (Size i = 0; i < spokes.size(); ++i) {
    if (!spokes[i]->isBoundary()) continue;
    std::rotate(spokes.begin(), spokes.begin() + static_cast<std::ptrdiff_t>(i), spokes.end());
    break;
  }
  return spokes;
}

HalfedgeIter lastBefore(HalfedgeIter h) {
  HalfedgeIter before = h;
  while (before->next() != h)
    before = before->next();
  return before;
}

// The sides around the faces of v, one after the other, but for those at v: what will be the
// sides of one face, counter-clockwise.
std::vector<HalfedgeIter> outline(const std::vector<HalfedgeIter>& spokes) {
  std::vector<HalfedgeIter> sides;
  for (auto spoke = spokes.rbegin(); spoke != spokes.rend(); ++spoke) {
    if ((*spoke)->isBoundary()) continue;
    for (HalfedgeIter h = (*spoke)->next(); h->next() != *spoke; h = h->next())
      sides.push_back(h);
  }
  return sides;
}

// Whether a face with these sides, and one more at a boundary, visits no vertex twice.
bool isFace(const std::vector<HalfedgeIter>& sides, bool boundary) {
  std::set<VertexIter> corners;
  for (HalfedgeIter side : sides)
    corners.insert(side->vertex());
  if (boundary) corners.insert(sides.back()->twin()->vertex());
  const Size n = sides.size() + (boundary ? 1 : 0);
  return corners.size() == n && n >= 3;
}

}  // namespace
// SOLUTION END

// EXERCISE vertex_dissolve: take a vertex away; the faces around it become one.
//
//      o ---- o ---- o        o ---- o ---- o
//      |      |      |        |             |
//      o ---- v ---- o        o      f      o         on a boundary: a new edge joins the two
//      |      |      |        |             |         neighbours of v there
//      o ---- o ---- o        o ---- o ---- o
//
// All edges at v go. On a boundary, what is left of the faces is closed by ONE new edge, and
// the boundary loop takes its other side.
//
// Look first, and return std::nullopt without a change, if no surface would be left: the new
// face would have fewer than three corners or visit one of them twice, or a boundary of three
// edges would lose one.
std::optional<FaceIter> PolyMesh::dissolveVertex(VertexIter v) {
  // SOLUTION BEGIN PolyMesh::dissolveVertex
  const std::vector<HalfedgeIter> spokes = spokesOf(v);
  const HalfedgeIter out = spokes.front();
  const bool boundary = out->isBoundary();
  std::vector<HalfedgeIter> sides = outline(spokes);
  if (!isFace(sides, boundary)) return std::nullopt;
  HalfedgeIter in;  // the half-edge outside that leads to v
  if (boundary) {
    in = lastBefore(out);
    if (out->next()->next() == in) return std::nullopt;
  }

  const FaceIter face = newFace();
  for (HalfedgeIter spoke : spokes) {
    if (!spoke->isBoundary()) deleteFace(spoke->face());
  }
  if (boundary) {
    // The edge of `in` becomes the new one: inside from the end of `out` to the start of `in`.
    const HalfedgeIter inside = in->twin();
    inside->vertex() = out->twin()->vertex();
    in->next() = out->next();
    in->face()->halfedge() = in;
    sides.push_back(inside);
  }
  for (Size i = 0; i < sides.size(); ++i) {
    sides[i]->next() = sides[(i + 1) % sides.size()];
    sides[i]->face() = face;
    sides[i]->vertex()->halfedge() = sides[i];
  }
  face->halfedge() = sides.front();
  for (HalfedgeIter spoke : spokes) {
    if (boundary && spoke == in->twin()) continue;
    deleteEdge(spoke->edge());
    deleteHalfedge(spoke->twin());
    deleteHalfedge(spoke);
  }
  deleteVertex(v);
  return face;
  // SOLUTION END
}

}  // namespace meshedit
