// Wrong: refuses boundary edges, and moves one of their ends.
#include "meshedit/meshedit.h"

namespace meshedit {

namespace {

// Puts m into the half-edge h, which keeps its start b and now ends at m. The rest of the way,
// from m to c, is a new half-edge in the same face or boundary loop.
//
//     before:  b ------- h ------> c         after:  b -- h --> m -- rest --> c
HalfedgeIter insertVertex(HalfedgeMesh& mesh, HalfedgeIter h, VertexIter m) {
  const HalfedgeIter rest = mesh.newHalfedge();
  rest->vertex() = m;
  rest->next() = h->next();
  rest->face() = h->face();
  h->next() = rest;
  return rest;
}

// Joins m, where h ends, to the vertex a opposite. The half with c becomes a new face.
//
//                a
//              / | \                    f, as before:   h, ma, ab
//         ab /   |   \ ca               the new face:   rest, ca, am
//          /   ma|am   \                ma runs from m to a, am from a to m
//        / f     |       \                                                         .
//       b -- h-- m -rest- c
void joinToOpposite(HalfedgeMesh& mesh, HalfedgeIter h) {
  const HalfedgeIter rest = h->next();
  const HalfedgeIter ca = rest->next();
  const HalfedgeIter ab = ca->next();
  const VertexIter m = rest->vertex();
  const VertexIter a = ab->vertex();
  const FaceIter f = h->face();

  const EdgeIter new_edge = mesh.newEdge();
  const HalfedgeIter ma = mesh.newHalfedge();
  const HalfedgeIter am = mesh.newHalfedge();
  const FaceIter new_face = mesh.newFace();
  new_edge->halfedge() = ma;
  new_edge->isNew = true;
  ma->setNeighbors(ab, am, m, new_edge, f);
  am->setNeighbors(rest, ma, a, new_edge, new_face);

  h->next() = ma;
  f->halfedge() = h;

  ca->next() = am;
  ca->face() = new_face;
  rest->face() = new_face;
  new_face->halfedge() = rest;
}

}  // namespace

VertexIter HalfedgeMesh::splitEdge(EdgeIter e0) {
  // First only the edge, with m in both half-edges. h and t keep their starts, so that no old
  // vertex and no neighbour outside notices, and each gets a new twin:
  //
  //      b -- h --> m -- h1 --> c         e0: h and t1        e1: h1 and t
  //      b <-- t1 - m <--- t -- c
  //
  // Then each side that is a triangle, and not a boundary loop, is cut in two.
  const HalfedgeIter h = e0->halfedge();
  const HalfedgeIter t = h->twin();
  if (e0->isBoundary()) {
    h->vertex()->position += Vector3D(0, 0, 0.5);
    return h->vertex();
  }

  const VertexIter m = newVertex();
  m->position = (h->vertex()->position + t->vertex()->position) / 2.0;
  m->isNew = true;
  const HalfedgeIter h1 = insertVertex(*this, h, m);
  const HalfedgeIter t1 = insertVertex(*this, t, m);
  m->halfedge() = h1;

  const EdgeIter e1 = newEdge();
  e1->halfedge() = h1;
  e1->isNew = e0->isNew;
  h1->edge() = e1;
  t->edge() = e1;
  t1->edge() = e0;
  h->twin() = t1;
  t1->twin() = h;
  h1->twin() = t;
  t->twin() = h1;

  if (!h->isBoundary()) joinToOpposite(*this, h);
  if (!t->isBoundary()) joinToOpposite(*this, t);
  return m;
}

}  // namespace meshedit
