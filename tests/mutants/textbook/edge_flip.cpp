#include "meshedit/meshedit.h"

namespace meshedit {

// The flip as textbooks do it: collect every element of the diamond, then set every pointer.
// Names tell what an element is AFTER the flip: ab runs from a to b, edge_ab is its edge, the
// corners of face_abd are a, b and d. The measure of dev-check --mutants relies on that.
EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::flipEdge
  if (e0->halfedge()->isBoundary() || e0->halfedge()->twin()->isBoundary()) return e0;

  const HalfedgeIter h = e0->halfedge();
  const HalfedgeIter t = h->twin();
  const FaceIter f = h->face();
  const FaceIter g = t->face();

  const HalfedgeIter ca = h->next();
  const HalfedgeIter ab = ca->next();
  const HalfedgeIter bd = t->next();
  const HalfedgeIter dc = bd->next();
  const HalfedgeIter ac = ca->twin();
  const HalfedgeIter ba = ab->twin();
  const HalfedgeIter db = bd->twin();
  const HalfedgeIter cd = dc->twin();

  const VertexIter a = ab->vertex();
  const VertexIter b = h->vertex();
  const VertexIter c = t->vertex();
  const VertexIter d = dc->vertex();

  const EdgeIter edge_ab = ab->edge();
  const EdgeIter edge_bd = bd->edge();
  const EdgeIter edge_dc = dc->edge();
  const EdgeIter edge_ca = ca->edge();
  const EdgeIter edge_ad = e0;

  const HalfedgeIter da = h;
  const HalfedgeIter ad = t;

  const FaceIter face_abd = f;
  const FaceIter face_adc = g;

  da->setNeighbors(ab, ad, d, edge_ad, face_abd);
  ab->setNeighbors(bd, ba, a, edge_ab, face_abd);
  bd->setNeighbors(da, db, b, edge_bd, face_abd);
  ad->setNeighbors(dc, da, a, edge_ad, face_adc);
  dc->setNeighbors(ca, cd, d, edge_dc, face_adc);
  ca->setNeighbors(ad, ac, c, edge_ca, face_adc);

  ba->setNeighbors(ba->next(), ab, b, edge_ab, ba->face());
  db->setNeighbors(db->next(), bd, d, edge_bd, db->face());
  cd->setNeighbors(cd->next(), dc, c, edge_dc, cd->face());
  ac->setNeighbors(ac->next(), ca, a, edge_ca, ac->face());

  a->halfedge() = ad;
  b->halfedge() = bd;
  c->halfedge() = ca;
  d->halfedge() = da;

  edge_ad->halfedge() = da;
  edge_ab->halfedge() = ab;
  edge_bd->halfedge() = bd;
  edge_dc->halfedge() = dc;
  edge_ca->halfedge() = ca;

  face_abd->halfedge() = da;
  face_adc->halfedge() = ad;
  return e0;
  // SOLUTION END
}

}  // namespace meshedit
