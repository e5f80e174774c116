#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE edge_split: put a new vertex m in the middle of the edge e0 and join it to the two
// vertices opposite.
//
//        before: b - c            after: b - m, m - c, a - m, d - m
//              a                       a
//            /   \                   / | \                                         .
//          b ----- c               b - m - c
//            \   /                   \ | /
//              d                       d
//
// That is +1 vertex, +3 edges, +2 faces, +6 half-edges. Every old element stays in use. Return
// m, with m->halfedge() along the old edge (towards b or c, not towards a or d).
//
// For Loop subdivision, mark what did not exist before: m->isNew = true, and the same for the
// edges a - m and d - m. Both halves of the old edge are NOT new: leave their isNew alone.
//
// A boundary edge has a triangle on one side only. Either leave the mesh as it is, or (extra
// credit) split that one triangle: +1 vertex, +2 edges, +1 face, +4 half-edges. The boundary
// loop outside is longer by one half-edge then.
VertexIter HalfedgeMesh::splitEdge(EdgeIter e0) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("HalfedgeMesh::splitEdge");
}

}  // namespace meshedit
