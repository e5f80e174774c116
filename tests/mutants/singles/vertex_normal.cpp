#include "meshedit/meshedit.h"

namespace meshedit {

Vector3D Vertex::normal() const {
  // SOLUTION BEGIN Vertex::normal
  Vector3D n(0, 0, 0);
  HalfedgeCIter h = halfedge();
  do {
    if (!h->face()->isBoundary()) {
      Vector3D p = h->vertex()->position;
      Vector3D q = h->next()->vertex()->position;
      Vector3D r = h->next()->next()->vertex()->position;
      n += cross(q - p, r - p);
    }
    h = h->twin()->next();
  } while (h != halfedge());
  n.normalize();
  return n;
  // SOLUTION END
}

}  // namespace meshedit
