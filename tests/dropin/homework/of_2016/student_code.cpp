#include "student_code.h"
#include "mutablePriorityQueue.h"

namespace CGL
{
  // Part 1: the sixteen Bernstein weights
  void BezierPatch::preprocess()
  {
    for (int i = 0; i < 4; i++)
      for (int j = 0; j < 4; j++)
        weights[i][j] = controlPoints[i][j];
  }

  Vector3D BezierPatch::evaluate(double u, double v, int deriv)
  {
    double bu[4] = { (1-u)*(1-u)*(1-u), 3*u*(1-u)*(1-u), 3*u*u*(1-u), u*u*u };
    double bv[4] = { (1-v)*(1-v)*(1-v), 3*v*(1-v)*(1-v), 3*v*v*(1-v), v*v*v };
    Vector3D p;
    for (int i = 0; i < 4; i++)
      for (int j = 0; j < 4; j++)
        p += bu[i] * bv[j] * weights[i][j];
    return p;
  }

  void BezierPatch::add2mesh(vector<Polygon>* mesh)
  {
    mesh->push_back(Polygon());
  }

  // sets all pointers of h
  void link(HalfedgeIter h, HalfedgeIter n, HalfedgeIter tw, VertexIter v, EdgeIter e, FaceIter f)
  {
    h->next() = n;
    h->twin() = tw;
    h->vertex() = v;
    h->edge() = e;
    h->face() = f;
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

    link(bc, ca, cb, a, e0, left);
    //  a -> d, d -> c, c -> a
    link(bc, dc, cb, a, e0, left);
    link(dc, ca, dc->twin(), d, dc->edge(), left);
    link(ca, bc, ca->twin(), c, ca->edge(), left);
    //  d -> a, a -> b, b -> d
    link(cb, ab, bc, d, e0, right);
    link(ab, bd, ab->twin(), a, ab->edge(), right);
    link(bd, cb, bd->twin(), b, bd->edge(), right);

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
    m->position = 0.5 * b->position + 0.5 * c->position;
    m->isNew = 1;

    EdgeIter mc = newEdge(), ma = newEdge(), md = newEdge();
    FaceIter f3 = newFace(), f4 = newFace();
    vector<HalfedgeIter> h;
    for (int i = 0; i < 6; i++) h.push_back(newHalfedge());

    link(bc, h[0], cb, b, e0, f1);
    link(h[0], ab, h[1], m, ma, f1);
    link(ab, bc, ab->twin(), a, ab->edge(), f1);

    link(h[1], h[2], h[0], a, ma, f3);
    link(h[2], ca, h[3], m, mc, f3);
    link(ca, h[1], ca->twin(), c, ca->edge(), f3);

    link(h[3], h[4], h[2], c, mc, f4);
    link(h[4], dc, h[5], m, md, f4);
    link(dc, h[3], dc->twin(), d, dc->edge(), f4);

    link(h[5], cb, h[4], d, md, f2);
    link(cb, bd, bc, m, e0, f2);
    link(bd, h[5], bd->twin(), b, bd->edge(), f2);

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
}
