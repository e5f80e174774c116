#include "meshedit/meshedit.h"

namespace meshedit {

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
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::weldEdges");
}

}  // namespace meshedit
