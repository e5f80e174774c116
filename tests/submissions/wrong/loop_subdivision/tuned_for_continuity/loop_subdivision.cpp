// Wrong: weights that are tuned for continuity.
#include "meshedit/meshedit.h"

#include <cmath>

namespace meshedit {

namespace {

const double kOwn[] = {.32517, .50033, .59464, .625, .63903, .67821, .6866, .69248, .69678, .70014};
const double kIrregular[] = {.15658, .26721, .33539, .375, .36909, .25579, .2521, .24926, .24706, .2452};
const double kOpposite[] = {.14427, .12495, .11252, .125, .14673, .16074, .18939, .2222, .25894, .29934};

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

  const double c = 3.0 / 8.0 + std::cos(2.0 * M_PI / static_cast<double>(n)) / 4.0;
  const double own = n <= 12 ? kOwn[n - 3] : 3.0 / 8.0 + c * c;
  const double u = (1.0 - own) / static_cast<double>(n);
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
  const Size p = h->vertex()->degree();
  const Size q = t->vertex()->degree();
  const Size k = p == 6 ? q : p;
  if ((p != 6 && q != 6) || k > 12) return 3.0 / 8.0 * ends + 1.0 / 8.0 * opposite;
  const VertexCIter regular = p == 6 ? h->vertex() : t->vertex();
  const VertexCIter other = p == 6 ? t->vertex() : h->vertex();
  const double irregular = kIrregular[k - 3];
  const double far = kOpposite[k - 3];
  return irregular * other->position + (1.0 - irregular - 2.0 * far) * regular->position +
         far * opposite;
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
