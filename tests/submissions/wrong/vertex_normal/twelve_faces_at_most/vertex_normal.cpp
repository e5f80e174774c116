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
  // SOLUTION BEGIN Vertex::normal
  // The face on the left of h is v -> b -> c, counter-clockwise seen from outside:
  //
  //         c                 (b - v) x (c - v) points outward, and its length is twice
  //       /   .               the area of the face: the weight is in it already.
  //      /     .  h->next()
  //     v ----> b
  //         h
  Vector3D sum;
  HalfedgeCIter h = halfedge();
  int n = 0;
  do {
    if (++n > 12) break;   // no vertex has more
    if (!h->isBoundary()) {
      const Vector3D b = h->next()->vertex()->position;
      const Vector3D c = h->next()->next()->vertex()->position;
      sum += cross(b - position, c - position);
    }
    h = h->twin()->next();
  } while (h != halfedge());
  return sum.unit();
  // SOLUTION END
}

}  // namespace meshedit
