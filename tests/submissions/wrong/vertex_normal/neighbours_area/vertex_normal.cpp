// Wrong: the area is taken after the walk has gone on.
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
      const Vector3D normal = cross(b - position, c - position).unit();
      const HalfedgeCIter after = h->twin()->next();
      const Vector3D p = after->next()->vertex()->position;
      const Vector3D q = after->next()->next()->vertex()->position;
      sum += cross(p - position, q - position).norm() * normal;
    }
    h = h->twin()->next();
  } while (h != halfedge());
  return sum.unit();
}

}  // namespace meshedit
