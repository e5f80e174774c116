#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

// Where an old vertex goes.
//
//     inside, n neighbours: u each, 1 - n u itself      on a boundary: its neighbours there
//
//            u     u                                          .   .
//              \ /                                            . .
//         u --- v --- u                               1/8 --- 3/4 --- 1/8
//              / \                                                                 .
//            u     u
Vector3D refinedVertex(VertexIter v) {
  double n = 0.0;
  Vector3D neighbours;
  Vector3D along;  // the neighbours along the boundary
  HalfedgeIter h = v->halfedge();
  do {
    const Vector3D p = h->twin()->vertex()->position;
    n += 1.0;
    neighbours += p;
    if (h->edge()->isBoundary()) along += p;
    h = h->twin()->next();
  } while (h != v->halfedge());
  if (v->isBoundary()) return 0.75 * v->position + 0.125 * along;
  const double u = n == 3.0 ? 3.0 / 16.0 : 3.0 / (8.0 * n);
  return (1.0 - n * u) * v->position + u * neighbours;
}

// Where the new vertex of an edge lies: 3/8 of each end and 1/8 of each vertex opposite; in the
// middle on a boundary.
Vector3D refinedEdge(EdgeIter e) {
  const HalfedgeIter h = e->halfedge();
  const HalfedgeIter t = h->twin();
  const Vector3D ends = h->vertex()->position + t->vertex()->position;
  if (e->isBoundary()) return 0.5 * ends;
  return 0.375 * ends + 0.125 * (h->next()->next()->vertex()->position +
                                 t->next()->next()->vertex()->position);
}

// Puts a vertex on an edge from a to b, and cuts no face: h from a to m, then a new half-edge
// from m to b; t from b to m, then a new one from m to a.
VertexIter putVertexOn(PolyMesh& mesh, EdgeIter e) {
  const HalfedgeIter h = e->halfedge();
  const HalfedgeIter t = h->twin();
  const VertexIter m = mesh.newVertex();
  const EdgeIter behind = mesh.newEdge();
  const HalfedgeIter mb = mesh.newHalfedge();
  const HalfedgeIter ma = mesh.newHalfedge();
  mb->setNeighbors(h->next(), t, m, behind, h->face());
  ma->setNeighbors(t->next(), h, m, e, t->face());
  h->next() = mb;
  h->twin() = ma;
  t->next() = ma;
  t->twin() = mb;
  t->edge() = behind;
  m->halfedge() = mb;
  e->halfedge() = h;
  behind->halfedge() = mb;
  return m;
}

// Cuts the three corners off a triangle that has a new vertex on each side.
//
//              v                    v
//             / \                  / \                                             .
//            m   m                m---m
//           /     \              / \ / \                                           .
//          v - m - v            v - m - v
//
void cutIntoFour(PolyMesh& mesh, FaceIter f) {
  std::vector<HalfedgeIter> sides;  // old half-edges still start at old vertices
  HalfedgeIter h = f->halfedge();
  do {
    sides.push_back(h);
    h = h->next();
  } while (h != f->halfedge());
  std::vector<HalfedgeIter> inner;  // [i] in the middle, across the corner of side 2 i
  std::vector<HalfedgeIter> outer;  // [i] its twin
  for (Size i = 0; i < 3; ++i) {
    inner.push_back(mesh.newHalfedge());
    outer.push_back(mesh.newHalfedge());
  }
  for (Size i = 0; i < 3; ++i) {
    const HalfedgeIter leaving = sides[2 * i];
    const HalfedgeIter arriving = sides[(2 * i + 5) % 6];
    const EdgeIter cut = mesh.newEdge();
    const FaceIter corner = mesh.newFace();
    outer[i]->setNeighbors(arriving, inner[i], sides[2 * i + 1]->vertex(), cut, corner);
    inner[i]->setNeighbors(inner[(i + 1) % 3], outer[i], arriving->vertex(), cut, f);
    leaving->next() = outer[i];
    leaving->face() = corner;
    arriving->face() = corner;
    cut->halfedge() = inner[i];
    corner->halfedge() = leaving;
  }
  f->halfedge() = inner[0];
}

}  // namespace
// SOLUTION END

// EXERCISE loop_refinement: one level of Loop subdivision, if all faces are triangles.
//
//              a                           a
//             / \                         / \                                      .
//            /   \                       o---o            o  new vertices, one on
//           /     \                     / \ / \              each old edge
//          b ----- c                   b---o---c
//
// All points come from the positions BEFORE the step. Old vertices stay, and move; which
// edges and faces are the old ones does not matter. If a face is no triangle, the mesh stays as
// it is, and false is returned.
bool PolyMesh::loopSubdivide() {
  // SOLUTION BEGIN PolyMesh::loopSubdivide
  std::vector<FaceIter> old_faces;
  for (FaceIter f = facesBegin(); f != facesEnd(); ++f) {
    if (f->degree() != 3) return false;
    old_faces.push_back(f);
  }
  for (VertexIter v = verticesBegin(); v != verticesEnd(); ++v)
    v->newPosition = refinedVertex(v);
  std::vector<EdgeIter> old_edges;
  for (EdgeIter e = edgesBegin(); e != edgesEnd(); ++e) {
    e->newPosition = refinedEdge(e);
    old_edges.push_back(e);
  }

  for (EdgeIter e : old_edges)
    putVertexOn(*this, e)->newPosition = e->newPosition;
  for (FaceIter f : old_faces)
    cutIntoFour(*this, f);
  for (VertexIter v = verticesBegin(); v != verticesEnd(); ++v)
    v->position = v->newPosition;
  return true;
  // SOLUTION END
}

}  // namespace meshedit
