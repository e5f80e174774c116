// Right: all exercises in one file, with a main() of its own.
#include "meshedit/meshedit.h"

using namespace std;
using namespace meshedit;

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  const double s = t;  // t is a float; all arithmetic is done in double
  std::vector<Vector2D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - s) * points[i] + s * points[i + 1]);
  }
  return next;
}

std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  std::vector<Vector3D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - t) * points[i] + t * points[i + 1]);
  }
  return next;
}

Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  std::vector<Vector3D> level = points;
  while (level.size() > 1) {
    level = evaluateStep(level, t);
  }
  return level.front();
}

Vector3D BezierPatch::evaluate(double u, double v) const {
  std::vector<Vector3D> column;
  for (const std::vector<Vector3D>& row : controlPoints) {
    column.push_back(evaluate1D(row, u));
  }
  return evaluate1D(column, v);
}

Vector3D Vertex::normal() const {
  // The face on the left of h is v -> b -> c, counter-clockwise seen from outside:
  //
  //         c                 (b - v) x (c - v) points outward, and its length is twice
  //       /   .               the area of the face: the weight is in it already.
  //      /     .  h->next()
  //     v ----> b
  //         h
  Vector3D sum;
  HalfedgeCIter h = halfedge();
  do {
    if (!h->isBoundary()) {
      const Vector3D b = h->next()->vertex()->position;
      const Vector3D c = h->next()->next()->vertex()->position;
      sum += cross(b - position, c - position);
    }
    h = h->twin()->next();
  } while (h != halfedge());
  return sum.unit();
}

EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  if (e0->isBoundary()) return EdgeIter();
  HalfedgeIter h0 = e0->halfedge(), h1 = h0->next(), h2 = h1->next();
  HalfedgeIter h3 = h0->twin(), h4 = h3->next(), h5 = h4->next();
  VertexIter b = h0->vertex(), c = h3->vertex(), a = h2->vertex(), d = h5->vertex();
  FaceIter f0 = h0->face(), f1 = h3->face();

  // h0 runs from a to d this time, and the faces change sides with it.
  h0->setNeighbors(h5, h3, a, e0, f0);
  h5->setNeighbors(h1, h5->twin(), d, h5->edge(), f0);
  h1->setNeighbors(h0, h1->twin(), c, h1->edge(), f0);
  h3->setNeighbors(h2, h0, d, e0, f1);
  h2->setNeighbors(h4, h2->twin(), a, h2->edge(), f1);
  h4->setNeighbors(h3, h4->twin(), b, h4->edge(), f1);

  a->halfedge() = h0;
  d->halfedge() = h3;
  b->halfedge() = h4;
  c->halfedge() = h1;
  e0->halfedge() = h3;
  f0->halfedge() = h5;
  f1->halfedge() = h4;
  return e0;
}

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

int main() {
  HalfedgeMesh mesh;
  mesh.build({{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  MeshResampler().upsample(mesh);
  cout << mesh.nFaces() << " triangles" << endl;
  return 0;
}
