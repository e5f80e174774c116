#include "meshedit/meshedit.h"

namespace meshedit {

// The split as textbooks do it: collect every element of the diamond, make the new ones, then
// set every pointer. Names tell what an element is AFTER the split: bm runs from b to m,
// edge_bm is its edge, the corners of face_abm are a, b and m. The measure of dev-check
// --mutants relies on that.
VertexIter HalfedgeMesh::splitEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::splitEdge
  HalfedgeIter h = e0->halfedge();
  HalfedgeIter t = h->twin();
  if (h->isBoundary()) std::swap(h, t);
  const FaceIter f = h->face();
  const FaceIter g = t->face();

  const HalfedgeIter ca = h->next();
  const HalfedgeIter ab = ca->next();

  const VertexIter a = ab->vertex();
  const VertexIter b = h->vertex();
  const VertexIter c = t->vertex();

  const VertexIter m = newVertex();
  m->position = 0.5 * (b->position + c->position);
  m->isNew = true;

  const EdgeIter edge_bm = e0;
  const EdgeIter edge_mc = newEdge();

  const EdgeIter edge_am = newEdge();
  edge_am->isNew = true;

  const FaceIter face_abm = f;
  const FaceIter face_amc = newFace();

  if (t->isBoundary()) {
    // The loop outside runs c -> m -> b: who led to t leads to cm, which must be t.
    const HalfedgeIter cm = t;

    const HalfedgeIter bm = h;
    const HalfedgeIter mc = newHalfedge();
    const HalfedgeIter mb = newHalfedge();
    const HalfedgeIter am = newHalfedge();
    const HalfedgeIter ma = newHalfedge();

    mb->setNeighbors(t->next(), bm, m, edge_bm, g);
    cm->setNeighbors(mb, mc, c, edge_mc, g);

    bm->setNeighbors(ma, mb, b, edge_bm, face_abm);
    ma->setNeighbors(ab, am, m, edge_am, face_abm);
    ab->next() = bm;
    ab->face() = face_abm;

    mc->setNeighbors(ca, cm, m, edge_mc, face_amc);
    ca->next() = am;
    ca->face() = face_amc;
    am->setNeighbors(mc, ma, a, edge_am, face_amc);

    a->halfedge() = am;
    b->halfedge() = bm;
    c->halfedge() = cm;
    m->halfedge() = mb;

    edge_bm->halfedge() = bm;
    edge_mc->halfedge() = mc;
    edge_am->halfedge() = am;

    face_abm->halfedge() = bm;
    face_amc->halfedge() = mc;
    return m;
  }

  const HalfedgeIter bd = t->next();
  const HalfedgeIter dc = bd->next();
  const VertexIter d = dc->vertex();

  const EdgeIter edge_dm = newEdge();
  edge_dm->isNew = true;

  const FaceIter face_mbd = g;
  const FaceIter face_cmd = newFace();

  const HalfedgeIter bm = h;
  const HalfedgeIter mb = t;
  const HalfedgeIter mc = newHalfedge();
  const HalfedgeIter cm = newHalfedge();
  const HalfedgeIter am = newHalfedge();
  const HalfedgeIter ma = newHalfedge();
  const HalfedgeIter dm = newHalfedge();
  const HalfedgeIter md = newHalfedge();

  bm->setNeighbors(ma, mb, b, edge_bm, face_abm);
  ma->setNeighbors(ab, am, m, edge_am, face_abm);
  ab->setNeighbors(bm, ab->twin(), a, ab->edge(), face_abm);

  mc->setNeighbors(ca, cm, m, edge_mc, face_amc);
  ca->setNeighbors(am, ca->twin(), c, ca->edge(), face_amc);
  am->setNeighbors(mc, ma, a, edge_am, face_amc);

  mb->setNeighbors(bd, bm, m, edge_bm, face_mbd);
  bd->setNeighbors(dm, bd->twin(), b, bd->edge(), face_mbd);
  dm->setNeighbors(mb, md, d, edge_dm, face_mbd);

  cm->setNeighbors(md, mc, c, edge_mc, face_cmd);
  md->setNeighbors(dc, dm, m, edge_dm, face_cmd);
  dc->setNeighbors(cm, dc->twin(), d, dc->edge(), face_cmd);

  a->halfedge() = am;
  b->halfedge() = bm;
  c->halfedge() = cm;
  d->halfedge() = dm;
  m->halfedge() = mb;

  edge_bm->halfedge() = bm;
  edge_mc->halfedge() = mc;
  edge_am->halfedge() = am;
  edge_dm->halfedge() = dm;

  face_abm->halfedge() = bm;
  face_amc->halfedge() = mc;
  face_mbd->halfedge() = mb;
  face_cmd->halfedge() = cm;
  return m;
  // SOLUTION END
}

}  // namespace meshedit
