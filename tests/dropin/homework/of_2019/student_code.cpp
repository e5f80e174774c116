#include "student_code.h"
#include "mutablePriorityQueue.h"

using namespace std;

// debug
static bool verbose = false;
static const char *banner = R"(
  { loop } "subdivision"
)";

static Vector3D lerp3D(Vector3D a, Vector3D b, double t) { return a + t * (b - a); }
static Vector2D lerp2D(Vector2D a, Vector2D b, double t) { return a + t * (b - a); }

namespace CGL
{
  void Vertex::computeCentroid() {
    centroid = Vector3D(0);
    int n = 0;
    HalfedgeIter h = halfedge();
    do {
      centroid += h->twin()->vertex()->position;
      ++n;
      h = h->twin()->next();
    } while (h != halfedge());
    centroid /= n;
  }

  void BezierCurve::evaluateStep(void)
  {
    // TODO Part 1.
    std::vector<Vector2D> lastLevel = evaluatedLevels.back();
    std::vector<Vector2D> newLevel;
    if (evaluatedLevels.size() >= numControlPoints) return;
    for (int i = 0; i < numControlPoints - evaluatedLevels.size(); ++i) {
      newLevel.push_back(lerp2D(lastLevel[i], lastLevel[i+1], t));
    }
    evaluatedLevels.push_back(newLevel);
  }

  Vector3D BezierPatch::evaluate(double u, double v) const
  {
    // TODO Part 2.
    std::vector<Vector3D> p;
    for (std::vector<Vector3D> row : controlPoints) p.push_back(evaluate1D(row, u));
    return evaluate1D(p, v);
  }

  Vector3D BezierPatch::evaluate1D(std::vector<Vector3D> points, double t) const
  {
    // TODO Part 2.
    if (points.size() == 1) return points[0];
    std::vector<Vector3D> next;
    for (int i = 0; i < points.size() - 1; ++i) next.push_back(lerp3D(points[i], points[i+1], t));
    return evaluate1D(next, t);
  }

  Vector3D Vertex::normal(void) const
  {
    // TODO Part 3.
    Vector3D total;
    HalfedgeCIter h = halfedge();
    for (;;) {
      if (!h->face()->isBoundary()) {
        Vector3D u = h->next()->vertex()->position - position;
        Vector3D w = h->next()->next()->vertex()->position - position;
        double area = cross(u, w).norm() / 2.0;
        total += area * h->face()->normal();
      }
      h = h->twin()->next();
      if (h == halfedge()) break;
    }
    return total / total.norm();
  }

  EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0)
  {
    // TODO Part 4.
    HalfedgeIter h0 = e0->halfedge(), h3 = h0->twin();
    if (h0->face()->isBoundary() || h3->face()->isBoundary()) return e0;
    HalfedgeIter h1 = h0->next(), h2 = h1->next(), h4 = h3->next(), h5 = h4->next();
    VertexIter v0 = h0->vertex(), v1 = h3->vertex(), v2 = h2->vertex(), v3 = h5->vertex();

    h0->vertex() = v3; h0->next() = h2;
    h3->vertex() = v2; h3->next() = h5;
    h2->next() = h4; h4->next() = h0; h4->face() = h0->face();
    h5->next() = h1; h1->next() = h3; h1->face() = h3->face();
    v0->halfedge() = h4;
    v1->halfedge() = h1;
    h0->face()->halfedge() = h0;
    h3->face()->halfedge() = h3;
    return e0;
  }

  VertexIter HalfedgeMesh::splitEdge(EdgeIter e0)
  {
    // TODO Part 5.
    HalfedgeIter h = e0->halfedge();
    if (h->isBoundary()) h = h->twin();
    HalfedgeIter t = h->twin();
    bool onBoundary = t->isBoundary();

    VertexIter b = h->vertex(), c = t->vertex();
    VertexIter m = newVertex();
    m->isNew = true;
    m->position = 0.5 * (b->position + c->position);

    // the half m - c
    EdgeIter e1 = newEdge();
    HalfedgeIter h1 = newHalfedge(), t1 = newHalfedge();
    HalfedgeIter beforeT;
    // t: c -> b becomes c -> m, and t1: m -> b
    t1->setNeighbors(t->next(), h, m, e0, t->face());
    h1->setNeighbors(h->next(), t, m, e1, h->face());
    h->setNeighbors(h1, t1, b, e0, h->face());
    t->setNeighbors(t1, h1, c, e1, t->face());
    e0->halfedge() = h;
    e1->halfedge() = h1;
    m->halfedge() = h1;

    int sides = onBoundary ? 1 : 2;
    for (int i = 0; i < sides; i++) {
      // x ends in m, y leaves m, then p and q
      HalfedgeIter x = (i == 0) ? h : t;
      HalfedgeIter y = x->next(), p = y->next(), q = p->next();
      FaceIter f = x->face(), g = newFace();
      EdgeIter e = newEdge();
      HalfedgeIter in = newHalfedge(), out = newHalfedge();
      out->setNeighbors(q, in, m, e, f);
      in->setNeighbors(y, out, q->vertex(), e, g);
      x->next() = out;
      p->next() = in;
      y->face() = g;
      p->face() = g;
      f->halfedge() = x;
      g->halfedge() = y;
      e->halfedge() = out;
      e->isNew = true;
    }
    return m;
  }

  void MeshResampler::upsample(HalfedgeMesh& mesh)
  {
    // TODO Part 6.
    if (verbose) cout << banner << mesh.nFaces() << " faces" << endl;
    std::vector<EdgeIter> olds;
    for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
      olds.push_back(e);
      e->isNew = false;
      HalfedgeIter h = e->halfedge();
      Vector3D ends = h->vertex()->position + h->twin()->vertex()->position;
      if (e->isBoundary()) {
        e->newPosition = ends * 0.5;
      } else {
        Vector3D wings = h->next()->next()->vertex()->position + h->twin()->next()->next()->vertex()->position;
        e->newPosition = ends * 3.0 / 8.0 + wings / 8.0;
      }
    }
    for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
      v->isNew = false;
      HalfedgeIter h = v->halfedge();
      Vector3D rim;
      do {
        if (h->edge()->isBoundary()) rim += h->twin()->vertex()->position;
        h = h->twin()->next();
      } while (h != v->halfedge());
      v->computeCentroid();
      double n = v->degree();
      double u = n == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * n);
      if (v->isBoundary()) v->newPosition = 0.75 * v->position + 0.125 * rim;
      else v->newPosition = (1 - n * u) * v->position + n * u * v->centroid;
    }
    for (EdgeIter e : olds) {
      Vector3D p = e->newPosition;
      mesh.splitEdge(e)->newPosition = p;
    }
    for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
      if (!e->isNew) continue;
      HalfedgeIter h = e->halfedge();
      if (h->vertex()->isNew + h->twin()->vertex()->isNew == 1) mesh.flipEdge(e);
    }
    for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) v->position = v->newPosition;
  }
}
