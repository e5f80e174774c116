#include "meshedit/meshedit.h"

namespace meshedit {

// The flip by the course's numbered diagram, each pointer set by an assignment of its own.
EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::flipEdge
  if (e0->isBoundary()) return e0;
  HalfedgeIter h0 = e0->halfedge();
  HalfedgeIter h1 = h0->next();
  HalfedgeIter h2 = h1->next();
  HalfedgeIter h3 = h0->twin();
  HalfedgeIter h4 = h3->next();
  HalfedgeIter h5 = h4->next();
  VertexIter v0 = h0->vertex();
  VertexIter v1 = h3->vertex();
  VertexIter v2 = h2->vertex();
  VertexIter v3 = h5->vertex();
  FaceIter f0 = h0->face();
  FaceIter f1 = h3->face();

  h0->vertex() = v3;
  h0->next() = h2;
  h2->next() = h4;
  h4->next() = h0;
  h4->face() = f0;

  h3->vertex() = v2;
  h3->next() = h5;
  h5->next() = h1;
  h1->next() = h3;
  h1->face() = f1;

  v0->halfedge() = h4;
  v1->halfedge() = h1;
  v2->halfedge() = h2;
  v3->halfedge() = h5;
  f0->halfedge() = h0;
  f1->halfedge() = h3;
  return e0;
  // SOLUTION END
}

}  // namespace meshedit
