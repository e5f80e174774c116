#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

// The vertex that the third edge at a corner leads to: that of the two edges of the face that
// are left out.
VertexIter outerCornerOf(HalfedgeIter side) {
  return side->twin()->next()->twin()->vertex();
}

}  // namespace
// SOLUTION END

// EXERCISE extrude_positions: place the corners of a face that extrudeFace() has made, while
// somebody drags it.
//
//      p3 --------- p2         m = the mean of p0, p1, p2, p3
//      | `q3 --- q2' |
//      |  |   f  |   |         each q = p + shrink (m - p) + move
//      |  |   m  |   |
//      | .q0 --- q1. |
//      p0 --------- p1
//
// shrink 0 is full size, 1 is a point, and less than 0 is larger. This is called again and
// again while the mouse moves, with all that it has moved since it went down: each call begins
// at p, never at where the last one left q.
void PolyMesh::placeExtruded(FaceIter f, const Vector3D& move, double shrink) {
  // SOLUTION BEGIN PolyMesh::placeExtruded
  std::vector<HalfedgeIter> sides;
  Vector3D mean(0, 0, 0);
  HalfedgeIter h = f->halfedge();
  do {
    sides.push_back(h);
    mean += outerCornerOf(h)->position;
    h = h->next();
  } while (h != f->halfedge());
  mean /= static_cast<double>(sides.size());
  for (HalfedgeIter side : sides) {
    const Vector3D p = outerCornerOf(side)->position;
    side->vertex()->position = p + shrink * (mean - p) + move;
  }
  // SOLUTION END
}

}  // namespace meshedit
