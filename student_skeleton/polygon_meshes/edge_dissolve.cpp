#include "meshedit/meshedit.h"

namespace meshedit {

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
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::dissolveEdge");
}

}  // namespace meshedit
