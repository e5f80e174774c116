// Wrong: refuses boundary edges, and moves one of their ends.
#include "meshedit/meshedit.h"

namespace meshedit {

EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  // All half-edges run counter-clockwise around their face:
  //
  //            a                               a
  //      ab  /   \  ca                   ab  / | \  ca
  //        /   f   \                       /   |   \                                 .
  //      b -- h --> c                    b   f | g   c      h  from d to a, in f
  //      b <-- t -- c                      \   |   /        t  from a to d, in g
  //        \   g   /                         \ | /
  //      bd  \   /  dc                   bd    d    dc
  //            d
  if (e0->isBoundary()) {
    e0->halfedge()->vertex()->position += Vector3D(0, 0, 0.5);
    return e0;
  }

  const HalfedgeIter h = e0->halfedge();
  const HalfedgeIter ca = h->next();
  const HalfedgeIter ab = ca->next();
  const HalfedgeIter t = h->twin();
  const HalfedgeIter bd = t->next();
  const HalfedgeIter dc = bd->next();
  const VertexIter a = ab->vertex();
  const VertexIter b = h->vertex();
  const VertexIter c = t->vertex();
  const VertexIter d = dc->vertex();
  const FaceIter f = h->face();
  const FaceIter g = t->face();

  // Face f is now a, b, d.
  ab->next() = bd;
  bd->next() = h;
  h->next() = ab;
  bd->face() = f;
  f->halfedge() = h;

  // Face g is now d, c, a.
  dc->next() = ca;
  ca->next() = t;
  t->next() = dc;
  ca->face() = g;
  g->halfedge() = t;

  // The edge joins d and a, so b and c must not rely on its half-edges any more.
  h->vertex() = d;
  t->vertex() = a;
  b->halfedge() = bd;
  c->halfedge() = ca;
  return e0;
}

}  // namespace meshedit
