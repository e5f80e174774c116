// Wrong: forgets to go around at its third call.
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
  static int calls = 0;
  const bool third = ++calls == 3;
  Vector3D sum;
  HalfedgeCIter h = halfedge();
  do {
    if (!h->isBoundary()) {
      const Vector3D b = h->next()->vertex()->position;
      const Vector3D c = h->next()->next()->vertex()->position;
      sum += cross(b - position, c - position);
    }
    h = h->twin()->next();
  } while (h != halfedge() && !third);
  return sum.unit();
}

}  // namespace meshedit
