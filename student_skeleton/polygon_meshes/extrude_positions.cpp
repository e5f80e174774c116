#include "meshedit/meshedit.h"

namespace meshedit {

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
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::placeExtruded");
}

}  // namespace meshedit
