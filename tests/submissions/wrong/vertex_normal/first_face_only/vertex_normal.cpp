// Wrong: the normal of one face is taken for all.
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
  HalfedgeCIter h = halfedge();
  if (h->isBoundary()) h = h->twin()->next();
  const Vector3D b = h->next()->vertex()->position;
  const Vector3D c = h->next()->next()->vertex()->position;
  return cross(b - position, c - position).unit();
}

}  // namespace meshedit
