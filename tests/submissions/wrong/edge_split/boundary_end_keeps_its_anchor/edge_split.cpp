#include "meshedit/meshedit.h"
namespace meshedit {
// The textbook: h becomes b - m, t becomes m - b, so c loses t and must have another half-edge.
VertexIter HalfedgeMesh::splitEdge(EdgeIter e0) {
  HalfedgeIter h = e0->halfedge();
  if (h->isBoundary()) h = h->twin();
  HalfedgeIter t = h->twin();
  const bool rim = t->isBoundary();
  HalfedgeIter ca = h->next(), ab = ca->next();
  VertexIter a = ab->vertex(), b = h->vertex(), c = t->vertex(), d;
  HalfedgeIter bd, dc, before;
  if (rim) {
    before = t; while (before->next() != t) before = before->next();
  } else { bd = t->next(); dc = bd->next(); d = dc->vertex(); }
  const bool c_at_rim = c->isBoundary();
  FaceIter f = h->face(), g = t->face();
  VertexIter m = newVertex();
  m->position = (b->position + c->position) / 2;
  m->isNew = true;
  EdgeIter e1 = newEdge(), ea = newEdge();
  ea->isNew = true;
  HalfedgeIter mc = newHalfedge(), cm = newHalfedge(), ma = newHalfedge(), am = newHalfedge();
  FaceIter f1 = newFace();
  h->next() = ma;
  ma->setNeighbors(ab, am, m, ea, f);
  mc->setNeighbors(ca, cm, m, e1, f1);
  ca->next() = am; ca->face() = f1;
  am->setNeighbors(mc, ma, a, ea, f1);
  t->vertex() = m;
  e1->halfedge() = mc; ea->halfedge() = ma; f->halfedge() = h; f1->halfedge() = mc; 
  m->halfedge() = t;
  if (rim) {
    cm->setNeighbors(t, mc, c, e1, g);
    before->next() = cm;
    c->halfedge() = cm;
    return m;
  }
  EdgeIter ed = newEdge(); ed->isNew = true;
  HalfedgeIter md = newHalfedge(), dm = newHalfedge();
  FaceIter g1 = newFace();
  // t (m -> b), bd, dm in g; cm, md, dc in g1
  bd->next() = dm; dm->setNeighbors(t, md, d, ed, g);
  cm->setNeighbors(md, mc, c, e1, g1);
  md->setNeighbors(dc, dm, m, ed, g1);
  dc->next() = cm; dc->face() = g1;
  ed->halfedge() = dm; g->halfedge() = t; g1->halfedge() = cm;
  if (!c_at_rim) c->halfedge() = cm;   // on the rim, it is the boundary half-edge anyway
  return m;
}
}
