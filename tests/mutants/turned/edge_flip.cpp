#include "meshedit/meshedit.h"

namespace meshedit {

// Here the half-edges turn: h0 to h5 keep their next, and get new vertices, edges and twins.
EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::flipEdge
  HalfedgeIter h0 = e0->halfedge();
  HalfedgeIter h3 = h0->twin();
  if (h0->isBoundary() || h3->isBoundary()) return e0;
  HalfedgeIter h1 = h0->next();
  HalfedgeIter h2 = h1->next();
  HalfedgeIter h4 = h3->next();
  HalfedgeIter h5 = h4->next();
  HalfedgeIter h6 = h1->twin();
  HalfedgeIter h7 = h2->twin();
  HalfedgeIter h8 = h4->twin();
  HalfedgeIter h9 = h5->twin();
  VertexIter v0 = h0->vertex();
  VertexIter v1 = h3->vertex();
  VertexIter v2 = h2->vertex();
  VertexIter v3 = h5->vertex();
  EdgeIter e1 = h1->edge();
  EdgeIter e2 = h2->edge();
  EdgeIter e3 = h4->edge();
  EdgeIter e4 = h5->edge();
  FaceIter f0 = h0->face();
  FaceIter f1 = h3->face();

  h0->setNeighbors(h1, h3, v3, e0, f0);
  h1->setNeighbors(h2, h7, v2, e2, f0);
  h2->setNeighbors(h0, h8, v0, e3, f0);
  h3->setNeighbors(h4, h0, v2, e0, f1);
  h4->setNeighbors(h5, h9, v3, e4, f1);
  h5->setNeighbors(h3, h6, v1, e1, f1);

  h6->twin() = h5;
  h7->twin() = h1;
  h8->twin() = h2;
  h9->twin() = h4;

  v0->halfedge() = h2;
  v1->halfedge() = h5;
  v2->halfedge() = h3;
  v3->halfedge() = h0;

  e0->halfedge() = h0;
  e1->halfedge() = h5;
  e2->halfedge() = h1;
  e3->halfedge() = h2;
  e4->halfedge() = h4;

  f0->halfedge() = h0;
  f1->halfedge() = h3;
  return e0;
  // SOLUTION END
}

}  // namespace meshedit
