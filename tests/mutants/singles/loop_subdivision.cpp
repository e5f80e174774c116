#include "meshedit/meshedit.h"

namespace meshedit {

void MeshResampler::upsample(HalfedgeMesh& mesh) {
  // SOLUTION BEGIN MeshResampler::upsample
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) {
    v->isNew = false;
    HalfedgeIter h = v->halfedge();
    if (v->isBoundary()) {
      v->newPosition = 0.75 * v->position;
      do {
        if (h->edge()->isBoundary()) v->newPosition += 0.125 * h->twin()->vertex()->position;
        h = h->twin()->next();
      } while (h != v->halfedge());
      continue;
    }
    double n = static_cast<double>(v->degree());
    double u = 3 / (8 * n);
    if (v->degree() == 3) u = 3.0 / 16;
    v->newPosition = (1 - n * u) * v->position;
    do {
      v->newPosition += u * h->twin()->vertex()->position;
      h = h->twin()->next();
    } while (h != v->halfedge());
  }

  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
    e->isNew = false;
    HalfedgeIter h = e->halfedge();
    Vector3D ends = h->vertex()->position + h->twin()->vertex()->position;
    e->newPosition = ends / 2;
    if (e->isBoundary()) continue;
    Vector3D c = h->next()->next()->vertex()->position;
    Vector3D d = h->twin()->next()->next()->vertex()->position;
    e->newPosition = ends * 3 / 8 + (c + d) / 8;
  }

  Size count = mesh.nEdges();
  EdgeIter e = mesh.edgesBegin();
  for (Size i = 0; i < count; i++) {
    EdgeIter next = e;
    next++;
    VertexIter m = mesh.splitEdge(e);
    m->newPosition = e->newPosition;
    e = next;
  }

  for (e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
    VertexIter a = e->halfedge()->vertex();
    VertexIter b = e->halfedge()->twin()->vertex();
    if (e->isNew && ((a->isNew && !b->isNew) || (!a->isNew && b->isNew))) mesh.flipEdge(e);
  }

  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) {
    v->position = v->newPosition;
  }
  // SOLUTION END
}

}  // namespace meshedit
