#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE loop_refinement: one level of Loop subdivision, if all faces are triangles.
//
//              a                           a
//             / \                         / \                                      .
//            /   \                       o---o            o  new vertices, one on
//           /     \                     / \ / \              each old edge
//          b ----- c                   b---o---c
//
// All points come from the positions BEFORE the step. Old vertices stay, and move; which
// edges and faces are the old ones does not matter. If a face is no triangle, the mesh stays as
// it is, and false is returned.
bool PolyMesh::loopSubdivide() {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::loopSubdivide");
}

}  // namespace meshedit
