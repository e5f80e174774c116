#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE face_extrude: make a copy of a face within it, and a ring of quads between the two.
//
//      p3 --------- p2        p3 --------- p2
//      |            |         | `q3 --- q2' |
//      |     f      |         |  |   f  |   |
//      |            |         |  |      |   |
//      |            |         | .q0 --- q1. |
//      p0 --------- p1        p0 --------- p1
//
// n corners: n new vertices, 2n new edges, n new faces. The new vertices lie AT THE SAME PLACES
// as the old corners: how far the copy moves is for later. Return the face in the middle.
std::optional<FaceIter> PolyMesh::extrudeFace(FaceIter f) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::extrudeFace");
}

}  // namespace meshedit
