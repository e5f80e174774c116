#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

// Cuts the face of `first`, which has four corners now, from its second to its fourth one.
EdgeIter cutFace(HalfedgeMesh& mesh, HalfedgeIter first) {
  std::vector<HalfedgeIter> h;
  for (int i = 0; i < 4; i++) {
    h.push_back(i == 0 ? first : h[i - 1]->next());
  }
  FaceIter old = first->face();
  FaceIter added = mesh.newFace();
  EdgeIter e = mesh.newEdge();
  HalfedgeIter to = mesh.newHalfedge();
  HalfedgeIter fro = mesh.newHalfedge();
  to->setNeighbors(h[3], fro, h[1]->vertex(), e, old);
  fro->setNeighbors(h[1], to, h[3]->vertex(), e, added);
  h[0]->next() = to;
  h[2]->next() = fro;
  for (int i = 1; i < 3; i++) {
    h[i]->face() = added;
  }
  e->halfedge() = to;
  old->halfedge() = to;
  added->halfedge() = fro;
  e->isNew = true;
  return e;
}

}  // namespace
// SOLUTION END

VertexIter HalfedgeMesh::splitEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::splitEdge
  HalfedgeIter old[] = {e0->halfedge(), e0->halfedge()->twin()};
  EdgeIter edge[] = {e0, newEdge()};
  HalfedgeIter added[] = {newHalfedge(), newHalfedge()};
  VertexIter m = newVertex();
  m->position = (old[0]->vertex()->position + old[1]->vertex()->position) / 2;
  m->isNew = true;

  for (int i = 0; i < 2; i++) {
    added[i]->setNeighbors(old[i]->next(), old[1 - i], m, edge[1 - i], old[i]->face());
  }
  for (int i = 0; i < 2; i++) {
    old[i]->next() = added[i];
    old[i]->twin() = added[1 - i];
    old[i]->edge() = edge[i];
    edge[i]->halfedge() = old[i];
  }
  m->halfedge() = added[0];

  for (HalfedgeIter h : old) {
    if (!h->isBoundary()) cutFace(*this, h);
  }
  return m;
  // SOLUTION END
}

}  // namespace meshedit
