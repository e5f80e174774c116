// Right: every number of the subdivision is a float, also on its way through the sums.
#include "meshedit/meshedit.h"

namespace meshedit {
struct F3 {
  float x = 0, y = 0, z = 0;
  F3() {}
  F3(float a, float b, float c) : x(a), y(b), z(c) {}
  F3(const Vector3D& p) : x((float)p.x), y((float)p.y), z((float)p.z) {}
  operator Vector3D() const { return Vector3D(x, y, z); }
  F3& operator+=(const F3& o) {
    x += o.x;
    y += o.y;
    z += o.z;
    return *this;
  }
};
inline F3 operator+(F3 a, const F3& b) {
  return a += b;
}
inline F3 operator*(float k, const F3& a) {
  return F3(k * a.x, k * a.y, k * a.z);
}

// SOLUTION BEGIN
namespace {

// Loop's own weights, in float.
Vector3D movedVertex(VertexIter v) {
  F3 sum;
  F3 ends;
  float n = 0;
  HalfedgeIter h = v->halfedge();
  do {
    F3 p = h->twin()->vertex()->position;
    sum += p;
    if (h->edge()->isBoundary()) ends += p;
    n += 1;
    h = h->twin()->next();
  } while (h != v->halfedge());
  if (v->isBoundary()) return 0.75f * F3(v->position) + 0.125f * ends;
  float c = 0.375f + 0.25f * std::cos(2 * 3.14159265f / n);
  float b = (0.625f - c * c) / n;
  return (1 - n * b) * F3(v->position) + b * sum;
}

}  // namespace
// SOLUTION END

// Collects the old edges, and splits and flips by what it collected.
void MeshResampler::upsample(HalfedgeMesh& mesh) {
  // SOLUTION BEGIN MeshResampler::upsample
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    v->newPosition = movedVertex(v);
    v->isNew = false;
  }

  std::vector<EdgeIter> old_edges;
  std::vector<Vector3D> points;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    HalfedgeIter h = e->halfedge();
    HalfedgeIter t = h->twin();
    F3 ends = F3(h->vertex()->position) + F3(t->vertex()->position);
    if (e->isBoundary()) {
      points.push_back(0.5f * ends);
    } else {
      F3 c = h->next()->next()->vertex()->position;
      F3 d = t->next()->next()->vertex()->position;
      points.push_back(0.375f * ends + 0.125f * (c + d));
    }
    e->isNew = false;
    old_edges.push_back(e);
  }

  for (std::size_t i = 0; i < old_edges.size(); ++i) {
    VertexIter m = mesh.splitEdge(old_edges[i]);
    m->isNew = true;
    m->newPosition = points[i];
  }

  std::vector<EdgeIter> crossing;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    if (e->isNew) crossing.push_back(e);
  }
  for (EdgeIter e : crossing) {
    VertexIter a = e->halfedge()->vertex();
    VertexIter b = e->halfedge()->twin()->vertex();
    if (a->isNew && b->isNew) continue;
    mesh.flipEdge(e);
  }

  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    v->position = v->newPosition;
  }
  // SOLUTION END
}

}  // namespace meshedit
