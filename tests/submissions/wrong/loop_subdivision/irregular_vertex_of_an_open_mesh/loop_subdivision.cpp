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
Vector3D pointOfVertex(VertexCIter v, bool open) {
  Size n = 0;
  bool on_boundary = false;
  Vector3D neighbours;
  Vector3D boundary_neighbours;
  HalfedgeCIter h = v->halfedge();
  do {
    const HalfedgeCIter t = h->twin();
    const Vector3D p = t->vertex()->position;
    ++n;
    neighbours += p;
    if (h->isBoundary() || t->isBoundary()) {
      on_boundary = true;
      boundary_neighbours += p;
    }
    h = t->next();
  } while (h != v->halfedge());
  if (on_boundary) return 3.0 / 4.0 * v->position + 1.0 / 8.0 * boundary_neighbours;

  const double u = open ? 1.0 / 16.0 : n == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * static_cast<double>(n));
  return (1.0 - static_cast<double>(n) * u) * v->position + u * neighbours;
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
  return 3.0 / 8.0 * ends + 1.0 / 8.0 * opposite;
}

}  // namespace
// SOLUTION END

// EXERCISE loop_subdivision: one level of Loop subdivision. Every triangle becomes four.
//
//              a                           a
//             / \                         / \                                      .
//            /   \                       o---o            o  new vertices, one on
//           /     \                     / \ / \              each old edge
//          b ----- c                   b---o---c
//
// The points and their weights are in mesh_resampler.h. All of them come from the positions
// BEFORE the step, so compute all first and move all last: `newPosition` of vertices and edges
// is there to keep them.
//
// One way to get the triangles is: split every old edge (in any order), then flip every new
// edge that joins an old vertex with a new one. `isNew` of vertices and edges tells which is
// which, if splitEdge sets it. Two traps: edges that you make while you walk over the edges
// are appended to the same list; and the next call starts with the marks that this one left.
//
// On a boundary (extra credit) other weights hold, and its edges need a splitEdge that splits
// them.
void MeshResampler::upsample(HalfedgeMesh& mesh) {
  // SOLUTION BEGIN MeshResampler::upsample
  // 1. All new points, from the old positions. What is here now is old.
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    v->newPosition = pointOfVertex(v, mesh.nBoundaries() > 0);
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
  // SOLUTION END
}

}  // namespace meshedit
