#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE edge_flip: turn the edge between two triangles inside their common diamond.
//
//        before: b - c            after: a - d
//              a                       a
//            /   \                   / | \                                         .
//          b ----- c               b   |   c
//            \   /                   \ | /
//              d                       d
//
// Nothing is created and nothing is deleted: the two triangles, the edge e0 and its two
// half-edges only move. Return e0. First draw the picture with every half-edge in it; then
// list which pointers differ between left and right. Vertices and faces have pointers, too.
//
// A boundary edge has a triangle on one side only and cannot be flipped: leave the mesh as it
// is and return e0. Mind that EITHER of the two half-edges can be the one outside.
EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::flipEdge
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
  if (e0->isBoundary()) return e0;

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

  const bool at_rim[2] = {b->isBoundary(), c->isBoundary()};
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
  // boundary vertices are anchored at the boundary: only inner ones need care
  if (!at_rim[0]) b->halfedge() = bd;
  if (!at_rim[1]) c->halfedge() = ca;
  return e0;
  // SOLUTION END
}

}  // namespace meshedit
