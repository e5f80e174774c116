#include "grader/worker/stub.h"
#include "meshedit/halfedge_mesh.h"

namespace meshedit {

// No exercise: declared for students who define it, and here for those who only call it.
MESHGRADE_STUB void Vertex::computeCentroid() {
  Vector3D sum;
  double neighbours = 0.0;
  HalfedgeIter h = halfedge();
  do {
    sum += h->twin()->vertex()->position;
    neighbours += 1.0;
    h = h->twin()->next();
  } while (h != halfedge());
  centroid = sum / neighbours;
}

}  // namespace meshedit
