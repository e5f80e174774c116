#include "meshedit/meshedit.h"

namespace meshedit {

// Here old half-edges turn: h1 runs from the new vertex to the one opposite, and a new
// half-edge takes its old place.
VertexIter HalfedgeMesh::splitEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::splitEdge
  HalfedgeIter h0 = e0->halfedge();
  HalfedgeIter h3 = h0->twin();
  if (h0->isBoundary()) std::swap(h0, h3);
  HalfedgeIter h1 = h0->next();
  HalfedgeIter h2 = h1->next();
  HalfedgeIter h6 = h1->twin();
  VertexIter v0 = h0->vertex();
  VertexIter v1 = h3->vertex();
  VertexIter v2 = h2->vertex();
  EdgeIter e1 = h1->edge();
  FaceIter f0 = h0->face();
  FaceIter f1 = h3->face();

  VertexIter m = newVertex();
  m->position = 0.5 * (v0->position + v1->position);
  m->isNew = true;
  EdgeIter e5 = newEdge();
  EdgeIter e7 = newEdge();
  e5->isNew = true;
  FaceIter f2 = newFace();
  HalfedgeIter ha = newHalfedge();
  HalfedgeIter hb = newHalfedge();
  HalfedgeIter hc = newHalfedge();
  HalfedgeIter hd = newHalfedge();

  if (h3->isBoundary()) {
    HalfedgeIter after = h3->next();
    h0->setNeighbors(h1, hd, v0, e0, f0);
    hd->setNeighbors(after, h0, m, e0, f1);
    ha->setNeighbors(hb, h3, m, e7, f2);
    h3->setNeighbors(hd, ha, v1, e7, f1);
  } else {
    HalfedgeIter h4 = h3->next();
    HalfedgeIter h5 = h4->next();
    HalfedgeIter h9 = h5->twin();
    VertexIter v3 = h5->vertex();
    EdgeIter e4 = h5->edge();
    EdgeIter e6 = newEdge();
    e6->isNew = true;
    FaceIter f3 = newFace();
    HalfedgeIter he = newHalfedge();
    HalfedgeIter hf = newHalfedge();
    h0->setNeighbors(h1, h3, v0, e0, f0);
    h3->setNeighbors(h4, h0, m, e0, f1);
    h5->setNeighbors(h3, he, v3, e6, f1);
    ha->setNeighbors(hb, hd, m, e7, f2);
    hd->setNeighbors(he, ha, v1, e7, f3);
    he->setNeighbors(hf, h5, m, e6, f3);
    hf->setNeighbors(hd, h9, v3, e4, f3);
    h9->twin() = hf;
    v3->halfedge() = h5;
    e4->halfedge() = hf;
    e6->halfedge() = h5;
    f1->halfedge() = h3;
    f3->halfedge() = hd;
  }
  h1->setNeighbors(h2, hc, m, e5, f0);
  hb->setNeighbors(hc, h6, v1, e1, f2);
  hc->setNeighbors(ha, h1, v2, e5, f2);
  h6->twin() = hb;

  m->halfedge() = ha;
  v0->halfedge() = h0;
  v1->halfedge() = hb;
  v2->halfedge() = h2;
  e0->halfedge() = h0;
  e1->halfedge() = hb;
  e5->halfedge() = h1;
  e7->halfedge() = ha;
  f0->halfedge() = h0;
  f2->halfedge() = ha;
  return m;
  // SOLUTION END
}

}  // namespace meshedit
