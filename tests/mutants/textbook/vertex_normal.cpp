#include "meshedit/meshedit.h"

namespace meshedit {

Vector3D Vertex::normal() const {
  // SOLUTION BEGIN Vertex::normal
  Vector3D sum;
  HalfedgeCIter h = halfedge();
  const HalfedgeCIter first = h;
  do {
    if (!h->face()->isBoundary()) {
      const Vector3D p = h->vertex()->position;
      const Vector3D q = h->next()->vertex()->position;
      const Vector3D r = h->next()->next()->vertex()->position;
      const double area = cross(q - p, r - p).norm() / 2.0;
      sum += area * h->face()->normal();
    }
    h = h->twin()->next();
  } while (h != first);
  const double length = sum.norm();
  return sum / length;
  // SOLUTION END
}

}  // namespace meshedit
