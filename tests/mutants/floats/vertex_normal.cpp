#include "meshedit/meshedit.h"

namespace meshedit {

// Computes in float.
Vector3D Vertex::normal() const {
  // SOLUTION BEGIN Vertex::normal
  float x = 0;
  float y = 0;
  float z = 0;
  HalfedgeCIter h = halfedge();
  do {
    if (!h->isBoundary()) {
      Vector3D a = h->next()->vertex()->position - position;
      Vector3D b = h->next()->next()->vertex()->position - position;
      Vector3D n = cross(a, b);
      x += static_cast<float>(n.x);
      y += static_cast<float>(n.y);
      z += static_cast<float>(n.z);
    }
    h = h->twin()->next();
  } while (h != halfedge());
  float length = std::sqrt(x * x + y * y + z * z);
  return Vector3D(x / length, y / length, z / length);
  // SOLUTION END
}

}  // namespace meshedit
