// Wrong: leaves out faces that it takes for degenerate.
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
      sum += (n.norm() > 1e-8 ? 1.0 : 0.0) * n;
    }
    h = h->twin()->next();
  } while (h != halfedge());
  return sum.unit();
}

}  // namespace meshedit
