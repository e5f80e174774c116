// Right: keeps what is old in sets, and asks no isNew.
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
  return 3.0 / 8.0 * ends + 1.0 / 8.0 * opposite;
}

}  // namespace

void MeshResampler::upsample(HalfedgeMesh& mesh) {
  std::set<VertexIter> old_vertices;
  std::map<EdgeIter, Vector3D> point_of;
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    v->newPosition = pointOfVertex(v);
    old_vertices.insert(v);
  }
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    point_of[e] = pointOfEdge(e);
  }

  std::set<EdgeIter> halves;  // of old edges
  for (const auto& [e, point] : point_of) {
    const VertexIter m = mesh.splitEdge(e);
    m->newPosition = point;
    halves.insert(e);
    halves.insert(m->halfedge()->edge());
  }

  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    if (halves.count(e) != 0) continue;
    const HalfedgeIter h = e->halfedge();
    const bool old_start = old_vertices.count(h->vertex()) != 0;
    const bool old_end = old_vertices.count(h->twin()->vertex()) != 0;
    if (old_start != old_end) mesh.flipEdge(e);
  }

  // 4. Move all vertices at once.
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    v->position = v->newPosition;
  }
}

}  // namespace meshedit
