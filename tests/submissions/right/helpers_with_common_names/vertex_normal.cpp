// Right: helpers of its own, with names that many choose.
#include "meshedit/meshedit.h"

namespace meshedit {

double area(Vector3D a, Vector3D b, Vector3D c) {
  return cross(b - a, c - a).norm() / 2;
}

Vector3D faceNormal(Vector3D a, Vector3D b, Vector3D c) {
  return cross(b - a, c - a).unit();
}

Vector3D average(const std::vector<Vector3D>& all) {
  Vector3D sum;
  for (const Vector3D& v : all)
    sum += v;
  return sum / all.size();
}

Vector3D Vertex::normal() const {
  std::vector<Vector3D> weighted;
  HalfedgeCIter h = _halfedge;
  do {
    if (!h->face()->isBoundary()) {
      Vector3D a = h->vertex()->position;
      Vector3D b = h->next()->vertex()->position;
      Vector3D c = h->next()->next()->vertex()->position;
      weighted.push_back(area(a, b, c) * faceNormal(a, b, c));
    }
    h = h->twin()->next();
  } while (h != _halfedge);
  return average(weighted).unit();
}

}  // namespace meshedit
