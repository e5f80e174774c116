#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

// The neighbours of a vertex; on a boundary only those along it.
std::vector<Vector3D> neighbours(VertexIter v) {
  std::vector<Vector3D> all;
  std::vector<Vector3D> outside;
  HalfedgeIter h = v->halfedge();
  do {
    all.push_back(h->twin()->vertex()->position);
    if (h->edge()->isBoundary()) outside.push_back(all.back());
    h = h->twin()->next();
  } while (h != v->halfedge());
  return outside.empty() ? all : outside;
}

}  // namespace
// SOLUTION END

// Everything in lists: old vertices with their new places, old edges with their new points, and
// the edges to flip.
void MeshResampler::upsample(HalfedgeMesh& mesh) {
  // SOLUTION BEGIN MeshResampler::upsample
  std::vector<VertexIter> vertices;
  std::vector<Vector3D> places;
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) {
    std::vector<Vector3D> around = neighbours(v);
    double n = static_cast<double>(around.size());
    double u = around.size() == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * n);
    if (v->isBoundary()) u = 1.0 / 8.0;
    Vector3D p = (1.0 - n * u) * v->position;
    for (const Vector3D& q : around) {
      p += u * q;
    }
    v->isNew = false;
    vertices.push_back(v);
    places.push_back(p);
  }

  std::vector<EdgeIter> edges;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
    e->isNew = false;
    edges.push_back(e);
  }
  for (EdgeIter e : edges) {
    HalfedgeIter h = e->halfedge();
    HalfedgeIter t = h->twin();
    Vector3D p = (h->vertex()->position + t->vertex()->position) / 2.0;
    if (!e->isBoundary()) {
      Vector3D opposite =
          h->next()->next()->vertex()->position + t->next()->next()->vertex()->position;
      p = 0.75 * p + 0.125 * opposite;
    }
    e->newPosition = p;
  }

  std::vector<VertexIter> middles;
  for (EdgeIter e : edges) {
    VertexIter m = mesh.splitEdge(e);
    m->newPosition = e->newPosition;
    middles.push_back(m);
  }

  std::vector<EdgeIter> to_flip;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
    bool one = e->halfedge()->vertex()->isNew;
    bool other = e->halfedge()->twin()->vertex()->isNew;
    if (e->isNew && one != other) to_flip.push_back(e);
  }
  for (EdgeIter e : to_flip) {
    mesh.flipEdge(e);
  }

  for (std::size_t i = 0; i < vertices.size(); i++) {
    vertices[i]->position = places[i];
  }
  for (VertexIter m : middles) {
    m->position = m->newPosition;
  }
  // SOLUTION END
}

}  // namespace meshedit
