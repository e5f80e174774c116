#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

// Loop's own weights, in float.
Vector3D movedVertex(VertexIter v) {
  Vector3D sum;
  Vector3D ends;
  float n = 0;
  HalfedgeIter h = v->halfedge();
  do {
    Vector3D p = h->twin()->vertex()->position;
    sum += p;
    if (h->edge()->isBoundary()) ends += p;
    n += 1;
    h = h->twin()->next();
  } while (h != v->halfedge());
  if (v->isBoundary()) return 0.75f * v->position + 0.125f * ends;
  float c = 0.375f + 0.25f * std::cos(2 * 3.14159265f / n);
  float b = (0.625f - c * c) / n;
  return (1 - n * b) * v->position + b * sum;
}

}  // namespace
// SOLUTION END

// Collects the old edges, and splits and flips by what it collected.
void MeshResampler::upsample(HalfedgeMesh& mesh) {
  // SOLUTION BEGIN MeshResampler::upsample
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    v->newPosition = movedVertex(v);
    v->isNew = false;
  }

  std::vector<EdgeIter> old_edges;
  std::vector<Vector3D> points;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    HalfedgeIter h = e->halfedge();
    HalfedgeIter t = h->twin();
    Vector3D ends = h->vertex()->position + t->vertex()->position;
    if (e->isBoundary()) {
      points.push_back(0.5f * ends);
    } else {
      Vector3D c = h->next()->next()->vertex()->position;
      Vector3D d = t->next()->next()->vertex()->position;
      points.push_back(0.375f * ends + 0.125f * (c + d));
    }
    e->isNew = false;
    old_edges.push_back(e);
  }

  for (std::size_t i = 0; i < old_edges.size(); ++i) {
    VertexIter m = mesh.splitEdge(old_edges[i]);
    m->isNew = true;
    m->newPosition = points[i];
  }

  std::vector<EdgeIter> crossing;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    if (e->isNew) crossing.push_back(e);
  }
  for (EdgeIter e : crossing) {
    VertexIter a = e->halfedge()->vertex();
    VertexIter b = e->halfedge()->twin()->vertex();
    if (a->isNew && b->isNew) continue;
    mesh.flipEdge(e);
  }

  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    v->position = v->newPosition;
  }
  // SOLUTION END
}

}  // namespace meshedit
