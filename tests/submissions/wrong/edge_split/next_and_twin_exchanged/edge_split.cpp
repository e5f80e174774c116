// Wrong: one call of setNeighbors has its first two arguments exchanged.
#include "meshedit/meshedit.h"

namespace meshedit {

VertexIter HalfedgeMesh::splitEdge(EdgeIter e0) {
  if (e0->isBoundary()) return VertexIter();
  HalfedgeIter h0 = e0->halfedge(), h1 = h0->next(), h2 = h1->next();
  HalfedgeIter h3 = h0->twin(), h4 = h3->next(), h5 = h4->next();
  VertexIter b = h0->vertex(), c = h3->vertex(), a = h2->vertex(), d = h5->vertex();
  EdgeIter e1 = h1->edge(), e2 = h2->edge(), e3 = h4->edge(), e4 = h5->edge();
  FaceIter f0 = h0->face(), f1 = h3->face();

  FaceIter f2 = newFace(), f3 = newFace();
  EdgeIter e5 = newEdge(), e6 = newEdge(), e7 = newEdge();
  VertexIter m = newVertex();
  HalfedgeIter h6 = newHalfedge(), h7 = newHalfedge(), h8 = newHalfedge();
  HalfedgeIter h9 = newHalfedge(), h10 = newHalfedge(), h11 = newHalfedge();

  m->position = 0.5 * b->position + 0.5 * c->position;
  m->isNew = true;

  // Face f0 is b m a, f1 is c m d, f2 is m c a, f3 is m b d.
  h0->setNeighbors(h6, h11, b, e0, f0);
  h6->setNeighbors(h7, h2, m, e5, f0);
  h2->setNeighbors(h0, h2->twin(), a, e2, f0);

  h3->setNeighbors(h9, h8, c, e6, f1);
  h9->setNeighbors(h5, h10, m, e7, f1);
  h5->setNeighbors(h3, h5->twin(), d, e4, f1);

  h8->setNeighbors(h1, h3, m, e6, f2);
  h1->setNeighbors(h7, h1->twin(), c, e1, f2);
  h7->setNeighbors(h8, h6, a, e5, f2);

  h11->setNeighbors(h4, h0, m, e0, f3);
  h4->setNeighbors(h10, h4->twin(), b, e3, f3);
  h10->setNeighbors(h11, h9, d, e7, f3);

  a->halfedge() = h2;
  b->halfedge() = h0;
  c->halfedge() = h3;
  d->halfedge() = h5;
  m->halfedge() = h11;

  e0->halfedge() = h0;
  e1->halfedge() = h1;
  e2->halfedge() = h2;
  e3->halfedge() = h4;
  e4->halfedge() = h5;
  e5->halfedge() = h6;
  e6->halfedge() = h3;
  e7->halfedge() = h9;
  e5->isNew = e7->isNew = true;

  f0->halfedge() = h0;
  f1->halfedge() = h3;
  f2->halfedge() = h8;
  f3->halfedge() = h11;
  return m;
}

}  // namespace meshedit
