// Right: makes the new triangles as a list and builds the mesh from it.
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
  std::vector<Vector3D> points;
  std::map<VertexIter, Index> index_of_vertex;
  std::map<EdgeIter, Index> index_of_edge;
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    index_of_vertex[v] = points.size();
    points.push_back(pointOfVertex(v));
  }
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    index_of_edge[e] = points.size();
    points.push_back(pointOfEdge(e));
  }

  std::vector<std::vector<Index>> triangles;
  for (FaceIter f = mesh.facesBegin(); f != mesh.facesEnd(); ++f) {
    const HalfedgeIter ab = f->halfedge(), bc = ab->next(), ca = bc->next();
    const Index m = index_of_edge[ab->edge()], n = index_of_edge[bc->edge()];
    const Index k = index_of_edge[ca->edge()];
    triangles.push_back({index_of_vertex[ab->vertex()], m, k});
    triangles.push_back({m, index_of_vertex[bc->vertex()], n});
    triangles.push_back({k, n, index_of_vertex[ca->vertex()]});
    triangles.push_back({m, n, k});
  }
  mesh.build(triangles, points);
}

}  // namespace meshedit
