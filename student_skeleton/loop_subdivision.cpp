#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE loop_subdivision: one level of Loop subdivision. Every triangle becomes four.
//
//              a                           a
//             / \                         / \                                      .
//            /   \                       o---o            o  new vertices, one on
//           /     \                     / \ / \              each old edge
//          b ----- c                   b---o---c
//
// The points and their weights are in mesh_resampler.h. All of them come from the positions
// BEFORE the step, so compute all first and move all last: `newPosition` of vertices and edges
// is there to keep them.
//
// One way to get the triangles is: split every old edge (in any order), then flip every new
// edge that joins an old vertex with a new one. `isNew` of vertices and edges tells which is
// which, if splitEdge sets it. Two traps: edges that you make while you walk over the edges
// are appended to the same list; and the next call starts with the marks that this one left.
//
// On a boundary (extra credit) other weights hold, and its edges need a splitEdge that splits
// them.
void MeshResampler::upsample(HalfedgeMesh& mesh) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("MeshResampler::upsample");
}

}  // namespace meshedit
