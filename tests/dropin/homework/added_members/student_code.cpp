#include "student_code.h"
#include "mutablePriorityQueue.h"

using namespace std;

namespace CGL
{

  template <typename T>
  T lerp(const T &a, const T &b, double t)
  {
    return (1 - t) * a + t * b;
  }

  /**
   * One step of de Casteljau for the curve.
   */
  std::vector<Vector2D> BezierCurve::evaluateStep(std::vector<Vector2D> const &points)
  {
    // TODO Part 1.
    std::vector<Vector2D> res;
    for (int i = 0; i < (int)points.size() - 1; i++)
      res.push_back(lerp(points[i], points[i + 1], this->t));
    return res;
  }

  std::vector<Vector3D> BezierPatch::evaluateStep(std::vector<Vector3D> const &points, double t) const
  {
    // TODO Part 2.
    std::vector<Vector3D> res;
    for (size_t i = 1; i < points.size(); i++)
      res.emplace_back(lerp(points[i - 1], points[i], t));
    return res;
  }

  Vector3D BezierPatch::evaluate1D(std::vector<Vector3D> const &points, double t) const
  {
    // TODO Part 2.
    std::vector<Vector3D> cur = points;
    while (cur.size() != 1) cur = evaluateStep(cur, t);
    return cur[0];
  }

  Vector3D BezierPatch::evaluate(double u, double v) const
  {
    // TODO Part 2.
    std::vector<Vector3D> col;
    for (auto const &row : controlPoints) {
      col.push_back(evaluate1D(row, u));
    }
    return evaluate1D(col, v);
  }

  Vector3D Vertex::normal( void ) const
  {
    // TODO Part 3.
    Vector3D n(0, 0, 0);
    HalfedgeCIter h = halfedge();
    do {
      Vector3D a = h->vertex()->position;
      Vector3D b = h->next()->vertex()->position;
      Vector3D c = h->next()->next()->vertex()->position;
      if (!h->face()->isBoundary())
        n += cross(b - a, c - a);
      h = h->twin()->next();
    } while (h != halfedge());
    return n.unit();
  }

  bool HalfedgeMesh::canFlip( EdgeIter e )
  {
    return !e->isBoundary();
  }

  EdgeIter HalfedgeMesh::flipEdge( EdgeIter e0 )
  {
    // TODO Part 4.
    if (!canFlip(e0)) {
      return EdgeIter();
    }

    // halfedges
    HalfedgeIter h0 = e0->halfedge();
    HalfedgeIter h1 = h0->next();
    HalfedgeIter h2 = h1->next();
    HalfedgeIter h3 = h0->twin();
    HalfedgeIter h4 = h3->next();
    HalfedgeIter h5 = h4->next();
    // outer ones
    HalfedgeIter h6 = h1->twin();
    HalfedgeIter h7 = h2->twin();
    HalfedgeIter h8 = h4->twin();
    HalfedgeIter h9 = h5->twin();
    // vertices
    VertexIter v0 = h0->vertex();
    VertexIter v1 = h3->vertex();
    VertexIter v2 = h2->vertex();
    VertexIter v3 = h5->vertex();
    // edges
    EdgeIter e1 = h1->edge();
    EdgeIter e2 = h2->edge();
    EdgeIter e3 = h4->edge();
    EdgeIter e4 = h5->edge();
    // faces
    FaceIter f0 = h0->face();
    FaceIter f1 = h3->face();

    // setNeighbors(next, twin, vertex, edge, face)
    h0->setNeighbors(h1, h3, v3, e0, f0);
    h1->setNeighbors(h2, h7, v2, e2, f0);
    h2->setNeighbors(h0, h8, v0, e3, f0);
    h3->setNeighbors(h4, h0, v2, e0, f1);
    h4->setNeighbors(h5, h9, v3, e4, f1);
    h5->setNeighbors(h3, h6, v1, e1, f1);
    h6->setNeighbors(h6->next(), h5, v2, e1, h6->face());
    h7->setNeighbors(h7->next(), h1, v0, e2, h7->face());
    h8->setNeighbors(h8->next(), h2, v3, e3, h8->face());
    h9->setNeighbors(h9->next(), h4, v1, e4, h9->face());

    v0->halfedge() = h2;
    v1->halfedge() = h5;
    v2->halfedge() = h1;
    v3->halfedge() = h0;

    e0->halfedge() = h0;
    e1->halfedge() = h5;
    e2->halfedge() = h1;
    e3->halfedge() = h2;
    e4->halfedge() = h4;

    f0->halfedge() = h0;
    f1->halfedge() = h3;

    return e0;
  }

  VertexIter HalfedgeMesh::splitEdge( EdgeIter e0 )
  {
    // TODO Part 5.
    if (e0->halfedge()->face()->isBoundary() || e0->halfedge()->twin()->face()->isBoundary())
      return VertexIter();

    HalfedgeIter h0 = e0->halfedge();
    HalfedgeIter h1 = h0->next();
    HalfedgeIter h2 = h1->next();
    HalfedgeIter h3 = h0->twin();
    HalfedgeIter h4 = h3->next();
    HalfedgeIter h5 = h4->next();
    VertexIter b = h0->vertex(), c = h3->vertex(), a = h2->vertex(), d = h5->vertex();
    FaceIter f0 = h0->face(), f1 = h3->face();

    VertexIter m = newVertex();
    EdgeIter e1 = newEdge(), e2 = newEdge(), e3 = newEdge();
    FaceIter f2 = newFace(), f3 = newFace();
    HalfedgeIter h6 = newHalfedge(), h7 = newHalfedge(), h8 = newHalfedge();
    HalfedgeIter h9 = newHalfedge(), h10 = newHalfedge(), h11 = newHalfedge();

    m->position = (b->position + c->position) / 2;
    m->isNew = true;
    m->timesSplit = b->timesSplit + 1;

    // b - m - a
    h0->setNeighbors(h6, h3, b, e0, f0);
    h6->setNeighbors(h2, h7, m, e2, f0);
    h2->setNeighbors(h0, h2->twin(), a, h2->edge(), f0);
    // m - c - a
    h8->setNeighbors(h1, h9, m, e1, f2);
    h1->setNeighbors(h7, h1->twin(), c, h1->edge(), f2);
    h7->setNeighbors(h8, h6, a, e2, f2);
    // c - m - d
    h9->setNeighbors(h10, h8, c, e1, f3);
    h10->setNeighbors(h5, h11, m, e3, f3);
    h5->setNeighbors(h9, h5->twin(), d, h5->edge(), f3);
    // m - b - d
    h3->setNeighbors(h4, h0, m, e0, f1);
    h4->setNeighbors(h11, h4->twin(), b, h4->edge(), f1);
    h11->setNeighbors(h3, h10, d, e3, f1);

    m->halfedge() = h8;
    b->halfedge() = h0;
    c->halfedge() = h1;
    a->halfedge() = h2;
    d->halfedge() = h5;
    e0->halfedge() = h0;
    e1->halfedge() = h8;
    e2->halfedge() = h6;
    e3->halfedge() = h10;
    f0->halfedge() = h0;
    f1->halfedge() = h3;
    f2->halfedge() = h8;
    f3->halfedge() = h9;
    e2->isNew = true;
    e3->isNew = true;
    return m;
  }

  Vector3D neighborSum(VertexIter v)
  {
    Vector3D sum = 0;
    HalfedgeIter h = v->halfedge();
    do {
      sum += h->twin()->vertex()->position;
      h = h->twin()->next();
    } while (h != v->halfedge());
    return sum;
  }

  void MeshResampler::markOld(HalfedgeMesh& mesh)
  {
    for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) v->isNew = false;
    for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) e->isNew = false;
  }

  void MeshResampler::upsample(HalfedgeMesh& mesh)
  {
    // TODO Part 6.
    calls++;
    markOld(mesh);

    for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
      HalfedgeIter h = e->halfedge();
      Vector3D A = h->vertex()->position;
      Vector3D B = h->twin()->vertex()->position;
      Vector3D C = h->next()->next()->vertex()->position;
      Vector3D D = h->twin()->next()->next()->vertex()->position;
      e->newPosition = weighted(0.375, A + B) + weighted(0.125, C + D);
    }

    scratch.clear();
    for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) {
      Size n = v->degree();
      double u = (n == 3) ? 3.0 / 16.0 : 3.0 / (8.0 * n);
      scratch.push_back((1.0 - n * u) * v->position + weighted(u, neighborSum(v)));
    }
    size_t k = 0;
    for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) v->newPosition = scratch[k++];

    EdgeIter last = mesh.edgesEnd();
    last--;
    for (EdgeIter e = mesh.edgesBegin(); ; e++) {
      VertexIter m = mesh.splitEdge(e);
      m->newPosition = e->newPosition;
      if (e == last) break;
    }

    for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
      if (!e->isNew) continue;
      bool a = e->halfedge()->vertex()->isNew;
      bool b = e->halfedge()->twin()->vertex()->isNew;
      if (a ^ b) mesh.flipEdge(e);
    }

    for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) {
      v->position = v->newPosition;
    }
  }
}
