/*
 * My solution. Everything is in this file.
 */

#include "student_code.h"
#include "mutablePriorityQueue.h"
#include "CGL/vector3D.h"

using namespace std;

#define MID(a, b) (((a)->position + (b)->position) / 2.0)
// sets all pointers of h
#define SET(h, nx, tw, v, e, f) (h)->setNeighbors((nx), (tw), (v), (e), (f))

namespace CGL
{
  void BezierCurve::evaluateStep()
  {
    // TODO Part 1.
    vector<Vector2D> last = evaluatedLevels[evaluatedLevels.size() - 1];
    if (last.size() <= 1) return;
    vector<Vector2D> level;
    for (unsigned i = 0; i + 1 < last.size(); i++) {
      level.push_back((1 - t) * last[i] + t * last[i + 1]);
    }
    evaluatedLevels.push_back(level);
  }

  Vector3D BezierPatch::evaluate(double u, double v) const
  {
    // TODO Part 2.
    vector<Vector3D> points;
    for (int i = 0; i < controlPoints.size(); i++) {
      points.push_back(evaluate1D(controlPoints[i], u));
    }
    return evaluate1D(points, v);
  }

  Vector3D BezierPatch::evaluate1D(std::vector<Vector3D> points, double t) const
  {
    // TODO Part 2.
    int n = points.size();
    for (int k = 1; k < n; k++)
      for (int i = 0; i < n - k; i++)
        points[i] = points[i] * (1.0 - t) + points[i + 1] * t;
    return points[0];
  }

  Vector3D Vertex::normal( void ) const
  {
    // TODO Part 3.
    Vector3D N(0., 0., 0.);
    HalfedgeCIter h = halfedge();
    HalfedgeCIter start = h;
    do {
      if (h->isBoundary() == false) {
        VertexCIter v1 = h->next()->vertex();
        VertexCIter v2 = h->next()->twin()->vertex();
        N += cross(v1->position - position, v2->position - position);
      }
      h = h->twin()->next();
    } while (h != start);
    N.normalize();
    return N;
  }

  EdgeIter HalfedgeMesh::flipEdge( EdgeIter e0 )
  {
    // TODO Part 4.
    if (e0->isBoundary()) return e0;

    HalfedgeIter bc = e0->halfedge(), cb = bc->twin();
    HalfedgeIter ca = bc->next(), ab = ca->next();
    HalfedgeIter bd = cb->next(), dc = bd->next();
    VertexIter a = ab->vertex(), b = bc->vertex(), c = ca->vertex(), d = dc->vertex();
    FaceIter left = bc->face(), right = cb->face();

    SET(bc, ca, cb, a, e0, left);
    //  a -> d, d -> c, c -> a
    SET(bc, dc, cb, a, e0, left);
    SET(dc, ca, dc->twin(), d, dc->edge(), left);
    SET(ca, bc, ca->twin(), c, ca->edge(), left);
    //  d -> a, a -> b, b -> d
    SET(cb, ab, bc, d, e0, right);
    SET(ab, bd, ab->twin(), a, ab->edge(), right);
    SET(bd, cb, bd->twin(), b, bd->edge(), right);

    a->halfedge() = ab; b->halfedge() = bd; c->halfedge() = ca; d->halfedge() = dc;
    left->halfedge() = bc; right->halfedge() = cb;
    e0->halfedge() = bc;
    return e0;
  }

  VertexIter HalfedgeMesh::splitEdge( EdgeIter e0 )
  {
    // TODO Part 5.
    if (e0->isBoundary()) return e0->halfedge()->vertex();

    HalfedgeIter bc = e0->halfedge(), cb = bc->twin();
    HalfedgeIter ca = bc->next(), ab = ca->next();
    HalfedgeIter bd = cb->next(), dc = bd->next();
    VertexIter a = ab->vertex(), b = bc->vertex(), c = ca->vertex(), d = dc->vertex();
    FaceIter f1 = bc->face(), f2 = cb->face();

    VertexIter m = this->newVertex();
    m->position = MID(b, c);
    m->isNew = 1;

    EdgeIter mc = newEdge(), ma = newEdge(), md = newEdge();
    FaceIter f3 = newFace(), f4 = newFace();
    vector<HalfedgeIter> h;
    for (int i = 0; i < 6; i++) h.push_back(newHalfedge());

    SET(bc, h[0], cb, b, e0, f1);
    SET(h[0], ab, h[1], m, ma, f1);
    SET(ab, bc, ab->twin(), a, ab->edge(), f1);

    SET(h[1], h[2], h[0], a, ma, f3);
    SET(h[2], ca, h[3], m, mc, f3);
    SET(ca, h[1], ca->twin(), c, ca->edge(), f3);

    SET(h[3], h[4], h[2], c, mc, f4);
    SET(h[4], dc, h[5], m, md, f4);
    SET(dc, h[3], dc->twin(), d, dc->edge(), f4);

    SET(h[5], cb, h[4], d, md, f2);
    SET(cb, bd, bc, m, e0, f2);
    SET(bd, h[5], bd->twin(), b, bd->edge(), f2);

    m->halfedge() = cb; a->halfedge() = ab; b->halfedge() = bc; c->halfedge() = ca;
    d->halfedge() = dc;
    e0->halfedge() = bc; mc->halfedge() = h[2]; ma->halfedge() = h[0]; md->halfedge() = h[4];
    f1->halfedge() = bc; f2->halfedge() = cb; f3->halfedge() = ca; f4->halfedge() = dc;
    ma->isNew = md->isNew = true;
    return m;
  }

  void MeshResampler::upsample(HalfedgeMesh& mesh)
  {
    // TODO Part 6.
    for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++) {
      v->isNew = false;
      float n = v->degree();
      float u = 3.0f / (8.0f * n);
      if (n == 3) u = 3.0f / 16.0f;
      Vector3D sum;
      HalfedgeIter h = v->halfedge();
      do {
        sum += h->twin()->vertex()->position;
        h = h->twin()->next();
      } while (h != v->halfedge());
      v->newPosition = (1.0f - n * u) * v->position + u * sum;
    }
    for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
      HalfedgeIter h = e->halfedge();
      e->isNew = false;
      e->newPosition = 3.f / 8 * (h->vertex()->position + h->twin()->vertex()->position)
                     + 1.f / 8 * (h->next()->next()->vertex()->position
                                  + h->twin()->next()->next()->vertex()->position);
    }

    int n = mesh.nEdges();
    EdgeIter e = mesh.edgesBegin();
    for (int i = 0; i < n; i++) {
      EdgeIter nextEdge = e;
      nextEdge++;
      if (!e->isNew) {
        Vector3D p = e->newPosition;
        VertexIter v = mesh.splitEdge(e);
        v->newPosition = p;
      }
      e = nextEdge;
    }

    for (e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
      if (e->isNew && (e->halfedge()->vertex()->isNew != e->halfedge()->twin()->vertex()->isNew))
        mesh.flipEdge(e);
    }
    for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++)
      v->position = v->newPosition;
    // cout << "done" << endl;
  }

  // Given an edge, the constructor for EdgeRecord finds the optimal point: not needed here.
}
