#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE edge_bevel: put a face in the place of an edge.
//
//      o               o        o                     o
//       `.           .'          `.                 .'
//         a ------- b              o ------------- o
//       .'           `.            |       f       |
//      o               o           o ------------- o
//                                .'                 `.
//                               o                     o
//
// Each OTHER edge at a and at b gets an end of its own, AT THE PLACE OF a or b: how far it
// moves is for later. These are the corners of the new face: if a has 4 edges and b has 3, it
// has 3 + 2 corners. The edge, a and b go.
//
// Look first, and return std::nullopt without a change, if the edge lies on a boundary, or if
// both of its ends have two edges only. With one such end, both is right.
std::optional<FaceIter> PolyMesh::bevelEdge(EdgeIter e) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::bevelEdge");
}

}  // namespace meshedit
