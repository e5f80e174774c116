#include "meshedit/meshedit.h"

namespace meshedit {

Vector3D Vertex::normal() const {
  // SOLUTION BEGIN Vertex::normal
  std::vector<HalfedgeCIter> around;
  HalfedgeCIter h = halfedge();
  do {
    around.push_back(h);
    h = h->twin()->next();
  } while (h != halfedge());
  Vector3D sum;
  for (HalfedgeCIter g : around) {
    if (g->isBoundary()) continue;
    Vector3D p[] = {position, g->next()->vertex()->position,
                    g->next()->next()->vertex()->position};
    sum += cross(p[1] - p[0], p[2] - p[0]) / 2;
  }
  return sum.unit();
  // SOLUTION END
}

}  // namespace meshedit
