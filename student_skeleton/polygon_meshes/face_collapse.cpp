#include "meshedit/meshedit.h"

namespace meshedit {

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
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::collapseFace");
}

}  // namespace meshedit
