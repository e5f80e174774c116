// Wrong: inside, the walk goes around the vertex where the first half-edge ends.
#include "meshedit/meshedit.h"

namespace meshedit {

Vector3D Vertex::normal() const {
  // The face on the left of h is v -> b -> c, counter-clockwise seen from outside:
  //
  //         c                 (b - v) x (c - v) points outward, and its length is twice
  //       /   .               the area of the face: the weight is in it already.
  //      /     .  h->next()
  //     v ----> b
  //         h
  Vector3D sum;
  HalfedgeCIter h = halfedge();
  do {
    if (!h->isBoundary()) {
      const Vector3D b = h->next()->vertex()->position;
      const Vector3D c = h->next()->next()->vertex()->position;
      sum += cross(b - position, c - position);
    }
    h = isBoundary() ? h->twin()->next() : h->next()->twin();
  } while (h != halfedge());
  return sum.unit();
}

}  // namespace meshedit
