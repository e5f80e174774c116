#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

void makeTriangle(FaceIter f, HalfedgeIter x, HalfedgeIter y, HalfedgeIter z) {
  x->next() = y;
  y->next() = z;
  z->next() = x;
  x->face() = f;
  y->face() = f;
  z->face() = f;
  x->vertex()->halfedge() = x;
  y->vertex()->halfedge() = y;
  z->vertex()->halfedge() = z;
  f->halfedge() = x;
}

}  // namespace
// SOLUTION END

// The flip by two triangles that are put together anew.
EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::flipEdge
  HalfedgeIter h = e0->halfedge();
  HalfedgeIter t = h->twin();
  if (h->isBoundary() || t->isBoundary()) return e0;
  HalfedgeIter hn = h->next();
  HalfedgeIter hp = hn->next();
  HalfedgeIter tn = t->next();
  HalfedgeIter tp = tn->next();
  FaceIter f = h->face();
  FaceIter g = t->face();
  h->vertex() = tp->vertex();
  t->vertex() = hp->vertex();
  makeTriangle(f, h, hp, tn);
  makeTriangle(g, t, tp, hn);
  return e0;
  // SOLUTION END
}

}  // namespace meshedit
