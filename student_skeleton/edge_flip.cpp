#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE edge_flip: turn the edge between two triangles inside their common diamond.
//
//        before: b - c            after: a - d
//              a                       a
//            /   \                   / | \                                         .
//          b ----- c               b   |   c
//            \   /                   \ | /
//              d                       d
//
// Nothing is created and nothing is deleted: the two triangles, the edge e0 and its two
// half-edges only move. Return e0. First draw the picture with every half-edge in it; then
// list which pointers differ between left and right. Vertices and faces have pointers, too.
//
// A boundary edge has a triangle on one side only and cannot be flipped: leave the mesh as it
// is and return e0. Mind that EITHER of the two half-edges can be the one outside.
EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("HalfedgeMesh::flipEdge");
}

}  // namespace meshedit
