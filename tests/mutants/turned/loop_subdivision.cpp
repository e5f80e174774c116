#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

bool isOld(EdgeIter e) {
  return !e->halfedge()->vertex()->isNew && !e->halfedge()->twin()->vertex()->isNew;
}

}  // namespace
// SOLUTION END

// Walks over the edges once and splits those between two old vertices.
void MeshResampler::upsample(HalfedgeMesh& mesh) {
  // SOLUTION BEGIN MeshResampler::upsample
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
    HalfedgeIter h = e->halfedge();
    Vector3D a = h->vertex()->position;
    Vector3D b = h->twin()->vertex()->position;
    e->isNew = false;
    if (e->isBoundary()) {
      e->newPosition = 0.5 * a + 0.5 * b;
      continue;
    }
    Vector3D c = h->next()->next()->vertex()->position;
    Vector3D d = h->twin()->next()->next()->vertex()->position;
    e->newPosition = 0.375 * a + 0.375 * b + 0.125 * c + 0.125 * d;
  }

  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) {
    v->isNew = false;
    Vector3D sum;
    Vector3D ends;
    int n = 0;
    HalfedgeIter h = v->halfedge();
    do {
      h = h->twin();
      sum += h->vertex()->position;
      if (h->edge()->isBoundary()) ends += h->vertex()->position;
      n++;
      h = h->next();
    } while (h != v->halfedge());
    double u = n == 3 ? 0.1875 : 0.375 / n;
    v->newPosition = v->position + u * (sum - n * v->position);
    if (v->isBoundary()) v->newPosition = 0.75 * v->position + 0.125 * ends;
  }

  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
    if (!isOld(e)) continue;
    Vector3D p = e->newPosition;
    mesh.splitEdge(e)->newPosition = p;
  }

  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
    bool a = e->halfedge()->vertex()->isNew;
    bool b = e->halfedge()->twin()->vertex()->isNew;
    if (e->isNew && a != b) mesh.flipEdge(e);
  }

  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) {
    v->position = v->newPosition;
  }
  // SOLUTION END
}

}  // namespace meshedit
