#include "meshedit/meshedit.h"

namespace meshedit {

Vector3D Vertex::normal() const {
  // SOLUTION BEGIN Vertex::normal
  Vector3D total;
  HalfedgeCIter start = halfedge();
  HalfedgeCIter h = start;
  do {
    HalfedgeCIter next = h->twin()->next();
    if (!h->isBoundary()) {
      Vector3D a = h->twin()->vertex()->position - position;
      Vector3D b = h->next()->next()->vertex()->position - position;
      total += cross(a, b);
    }
    h = next;
  } while (h != start);
  return total / total.norm();
  // SOLUTION END
}

}  // namespace meshedit
