#include "meshedit/meshedit.h"

namespace meshedit {

// The split by the course's numbered diagram, each pointer set by an assignment of its own.
// Both old half-edges keep their start, so nobody who leads to them has to be found.
VertexIter HalfedgeMesh::splitEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::splitEdge
  HalfedgeIter h0 = e0->halfedge();
  HalfedgeIter h3 = h0->twin();
  VertexIter v0 = h0->vertex();
  VertexIter v1 = h3->vertex();

  VertexIter v4 = newVertex();
  v4->isNew = true;
  v4->position = (v0->position + v1->position) / 2;
  EdgeIter e5 = newEdge();
  HalfedgeIter h10 = newHalfedge();
  HalfedgeIter h11 = newHalfedge();

  h10->vertex() = v4;
  h10->edge() = e5;
  h10->twin() = h3;
  h10->next() = h0->next();
  h10->face() = h0->face();
  h11->vertex() = v4;
  h11->edge() = e0;
  h11->twin() = h0;
  h11->next() = h3->next();
  h11->face() = h3->face();
  h0->twin() = h11;
  h0->next() = h10;
  h3->twin() = h10;
  h3->next() = h11;
  h3->edge() = e5;
  e5->halfedge() = h10;
  e0->halfedge() = h0;
  v4->halfedge() = h10;

  if (!h0->isBoundary()) {
    HalfedgeIter h1 = h10->next();
    HalfedgeIter h2 = h1->next();
    FaceIter f0 = h0->face();
    EdgeIter e6 = newEdge();
    FaceIter f2 = newFace();
    HalfedgeIter h12 = newHalfedge();
    HalfedgeIter h13 = newHalfedge();
    e6->isNew = true;
    e6->halfedge() = h12;
    h12->vertex() = v4;
    h12->edge() = e6;
    h12->twin() = h13;
    h12->next() = h2;
    h12->face() = f0;
    h13->vertex() = h2->vertex();
    h13->edge() = e6;
    h13->twin() = h12;
    h13->next() = h10;
    h13->face() = f2;
    h0->next() = h12;
    h1->next() = h13;
    h1->face() = f2;
    h10->face() = f2;
    f0->halfedge() = h0;
    f2->halfedge() = h10;
  }

  if (!h3->isBoundary()) {
    HalfedgeIter h4 = h11->next();
    HalfedgeIter h5 = h4->next();
    FaceIter f1 = h3->face();
    EdgeIter e7 = newEdge();
    FaceIter f3 = newFace();
    HalfedgeIter h14 = newHalfedge();
    HalfedgeIter h15 = newHalfedge();
    e7->isNew = true;
    e7->halfedge() = h14;
    h14->vertex() = v4;
    h14->edge() = e7;
    h14->twin() = h15;
    h14->next() = h5;
    h14->face() = f1;
    h15->vertex() = h5->vertex();
    h15->edge() = e7;
    h15->twin() = h14;
    h15->next() = h11;
    h15->face() = f3;
    h3->next() = h14;
    h4->next() = h15;
    h4->face() = f3;
    h11->face() = f3;
    f1->halfedge() = h3;
    f3->halfedge() = h11;
  }
  return v4;
  // SOLUTION END
}

}  // namespace meshedit
