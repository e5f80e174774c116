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
  f->halfedge() = x;
}

void makeEdge(EdgeIter e, HalfedgeIter x, HalfedgeIter y) {
  x->twin() = y;
  y->twin() = x;
  x->edge() = e;
  y->edge() = e;
  e->halfedge() = x;
}

float middle(double x, double y) {
  return 0.5f * (static_cast<float>(x) + static_cast<float>(y));
}

}  // namespace
// SOLUTION END

// The split by triangles and edges that are put together anew. Computes in float.
VertexIter HalfedgeMesh::splitEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::splitEdge
  HalfedgeIter h = e0->halfedge();
  if (h->isBoundary()) h = h->twin();
  HalfedgeIter t = h->twin();
  HalfedgeIter hn = h->next();
  HalfedgeIter hp = hn->next();
  VertexIter c = t->vertex();
  Vector3D p = h->vertex()->position;
  Vector3D q = c->position;

  VertexIter m = newVertex();
  m->position = Vector3D(middle(p.x, q.x), middle(p.y, q.y), middle(p.z, q.z));
  m->isNew = true;
  HalfedgeIter mc = newHalfedge();
  HalfedgeIter cm = newHalfedge();
  HalfedgeIter ma = newHalfedge();
  HalfedgeIter am = newHalfedge();
  EdgeIter along = newEdge();
  EdgeIter across = newEdge();
  across->isNew = true;
  mc->vertex() = m;
  ma->vertex() = m;
  am->vertex() = hp->vertex();
  makeTriangle(h->face(), h, ma, hp);
  makeTriangle(newFace(), mc, hn, am);
  makeEdge(across, ma, am);
  m->halfedge() = mc;

  if (t->isBoundary()) {
    cm->vertex() = m;
    cm->next() = t->next();
    cm->face() = t->face();
    t->next() = cm;
    makeEdge(e0, h, cm);
    makeEdge(along, mc, t);
    return m;
  }

  HalfedgeIter tn = t->next();
  HalfedgeIter tp = tn->next();
  HalfedgeIter md = newHalfedge();
  HalfedgeIter dm = newHalfedge();
  EdgeIter below = newEdge();
  below->isNew = true;
  t->vertex() = m;
  cm->vertex() = c;
  md->vertex() = m;
  dm->vertex() = tp->vertex();
  makeTriangle(t->face(), t, tn, dm);
  makeTriangle(newFace(), cm, md, tp);
  makeEdge(below, md, dm);
  makeEdge(along, mc, cm);
  c->halfedge() = cm;
  return m;
  // SOLUTION END
}

}  // namespace meshedit
