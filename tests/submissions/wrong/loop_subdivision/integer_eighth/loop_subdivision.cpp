// Wrong: only the ends count, since 1 / 8 is zero.
#include "meshedit/meshedit.h"

namespace meshedit {

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
Vector3D pointOfVertex(VertexCIter v) {
  Vector3D neighbours;
  Vector3D boundary_neighbours;
  HalfedgeCIter h = v->halfedge();
  do {
    const Vector3D p = h->twin()->vertex()->position;
    neighbours += p;
    if (h->edge()->isBoundary()) boundary_neighbours += p;
    h = h->twin()->next();
  } while (h != v->halfedge());
  if (v->isBoundary()) return 3.0 / 4.0 * v->position + 1.0 / 8.0 * boundary_neighbours;

  const double n = static_cast<double>(v->degree());
  const double u = v->degree() == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * n);
  return (1.0 - n * u) * v->position + u * neighbours;
}

// Where the new vertex of an edge goes.
//
//     inside:        1/8                  on a boundary:
//                   /   \                                                          .
//                3/8 --- 3/8                     1/2 --- 1/2
//                   \   /
//                    1/8
Vector3D pointOfEdge(EdgeCIter e) {
  const HalfedgeCIter h = e->halfedge();
  const HalfedgeCIter t = h->twin();
  const Vector3D ends = h->vertex()->position + t->vertex()->position;
  if (e->isBoundary()) return 1.0 / 2.0 * ends;

  const Vector3D opposite =
      h->next()->next()->vertex()->position + t->next()->next()->vertex()->position;
  return 3.0 / 8.0 * ends + 1 / 8 * opposite;
}

}  // namespace

void MeshResampler::upsample(HalfedgeMesh& mesh) {
  // 1. All new points, from the old positions. What is here now is old.
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    v->newPosition = pointOfVertex(v);
    v->isNew = false;
  }
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    e->newPosition = pointOfEdge(e);
    e->isNew = false;
  }

  // 2. Split the old edges: the first n of the list, as new ones are appended.
  const Size n = mesh.nEdges();
  EdgeIter e = mesh.edgesBegin();
  for (Size i = 0; i < n; ++i, ++e) {
    const Vector3D point = e->newPosition;
    mesh.splitEdge(e)->newPosition = point;
  }

  // 3. Flip the new edges between an old and a new vertex.
  for (e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    const HalfedgeIter h = e->halfedge();
    if (e->isNew && h->vertex()->isNew != h->twin()->vertex()->isNew) mesh.flipEdge(e);
  }

  // 4. Move all vertices at once.
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    v->position = v->newPosition;
  }
}

}  // namespace meshedit
