#include "meshedit/meshedit.h"

namespace meshedit {

void MeshResampler::upsample(HalfedgeMesh& mesh) {
  // SOLUTION BEGIN MeshResampler::upsample
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) {
    v->isNew = false;
    Vector3D inner_sum;
    Vector3D border_sum;
    HalfedgeIter h = v->halfedge();
    const HalfedgeIter first = h;
    double n = 0.0;
    do {
      const Vector3D p = h->twin()->vertex()->position;
      inner_sum += p;
      if (h->edge()->isBoundary()) border_sum += p;
      n += 1.0;
      h = h->twin()->next();
    } while (h != first);
    double u = 3.0 / (8.0 * n);
    if (n == 3.0) u = 3.0 / 16.0;
    v->newPosition = (1.0 - n * u) * v->position + u * inner_sum;
    if (v->isBoundary()) v->newPosition = 0.75 * v->position + 0.125 * border_sum;
  }

  std::vector<EdgeIter> old_edges;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
    e->isNew = false;
    old_edges.push_back(e);
    const HalfedgeIter h = e->halfedge();
    const HalfedgeIter t = h->twin();
    const VertexIter a = h->vertex();
    const VertexIter b = t->vertex();
    if (e->isBoundary()) {
      e->newPosition = (a->position + b->position) / 2.0;
    } else {
      const VertexIter c = h->next()->next()->vertex();
      const VertexIter d = t->next()->next()->vertex();
      e->newPosition =
          0.375 * (a->position + b->position) + 0.125 * (c->position + d->position);
    }
  }

  for (EdgeIter e : old_edges) {
    const Vector3D middle = e->newPosition;
    const VertexIter m = mesh.splitEdge(e);
    m->newPosition = middle;
    m->isNew = true;
  }

  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
    if (!e->isNew) continue;
    const bool one = e->halfedge()->vertex()->isNew;
    const bool other = e->halfedge()->twin()->vertex()->isNew;
    if (one != other) mesh.flipEdge(e);
  }

  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) {
    v->position = v->newPosition;
  }
  // SOLUTION END
}

}  // namespace meshedit
