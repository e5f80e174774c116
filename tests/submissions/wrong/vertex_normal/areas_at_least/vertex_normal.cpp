// Wrong: weighs every face by at least 1e-9.
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
      const Vector3D n = cross(b - position, c - position);
      sum += std::max(n.norm(), 1e-9) * n.unit();
    }
    h = h->twin()->next();
  } while (h != halfedge());
  return sum.unit();
}

}  // namespace meshedit
