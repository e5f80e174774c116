// Right: walks the other way, and adds doubled areas of the corner before.
#include "meshedit/meshedit.h"

namespace meshedit {

Vector3D Vertex::normal() const {
  Vector3D n(0, 0, 0);
  HalfedgeCIter start = halfedge();
  HalfedgeCIter h = start;
  do {
    HalfedgeCIter before = h;  // the half-edge that ends here, in the face of h
    while (before->next() != h)
      before = before->next();
    if (!before->isBoundary()) {
      Vector3D a = before->vertex()->position;
      Vector3D b = h->next()->vertex()->position;
      n += cross(a - b, position - b) * -0.5 * -1;
    }
    h = before->twin();
  } while (h != start);
  n.normalize();
  return n;
}

}  // namespace meshedit
