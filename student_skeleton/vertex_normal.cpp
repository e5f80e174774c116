#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE vertex_normal: the outward unit normal at this vertex.
//
//           c-------b             The faces around the vertex are triangles. Each of them has
//          / .  f1 / .            a normal and an area, and large faces count for more: the
//         /   .   /   .           normal of the vertex is the sum of
//        / f2  . / f0  .
//       d------ v ------a             area(f) * (unit normal of f)
//        .     / .
//          .  /   .               over all faces around it, scaled to length 1.
//            e-----x
//
// On the boundary of the surface, one of the "faces" around the vertex is the boundary loop
// (face()->isBoundary()). It is no part of the surface and does not count.
//
// The function is const: take HalfedgeCIter and VertexCIter for what you read.
Vector3D Vertex::normal() const {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("Vertex::normal");
}

}  // namespace meshedit
