// Wrong: one call of setNeighbors has its first two arguments exchanged.
#include "meshedit/meshedit.h"

namespace meshedit {

EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  if (e0->isBoundary()) return EdgeIter();
  HalfedgeIter h0 = e0->halfedge(), h1 = h0->next(), h2 = h1->next();
  HalfedgeIter h3 = h0->twin(), h4 = h3->next(), h5 = h4->next();
  VertexIter b = h0->vertex(), c = h3->vertex(), a = h2->vertex(), d = h5->vertex();
  FaceIter f0 = h0->face(), f1 = h3->face();

  // h0 runs from a to d this time, and the faces change sides with it.
  h0->setNeighbors(h5, h3, a, e0, f0);
  h5->setNeighbors(h5->twin(), h1, d, h5->edge(), f0);
  h1->setNeighbors(h0, h1->twin(), c, h1->edge(), f0);
  h3->setNeighbors(h2, h0, d, e0, f1);
  h2->setNeighbors(h4, h2->twin(), a, h2->edge(), f1);
  h4->setNeighbors(h3, h4->twin(), b, h4->edge(), f1);

  a->halfedge() = h0;
  d->halfedge() = h3;
  b->halfedge() = h4;
  c->halfedge() = h1;
  e0->halfedge() = h3;
  f0->halfedge() = h5;
  f1->halfedge() = h4;
  return e0;
}

}  // namespace meshedit
