#include <map>
#include <set>

#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

// The quadric v^T A v + 2 b . v + c of a point v. A is symmetric.
struct ErrorQuadric {
  Vector3D A[3];  // its columns
  Vector3D b;
  double c = 0.0;

  double at(const Vector3D& v) const {
    return dot(v, v.x * A[0] + v.y * A[1] + v.z * A[2]) + 2.0 * dot(b, v) + c;
  }
};

ErrorQuadric operator+(const ErrorQuadric& p, const ErrorQuadric& q) {
  return {{p.A[0] + q.A[0], p.A[1] + q.A[1], p.A[2] + q.A[2]}, p.b + q.b, p.c + q.c};
}

// The squared distance from the plane of a triangle. None if it has no area.
ErrorQuadric quadricOf(FaceIter f) {
  const HalfedgeIter h = f->halfedge();
  const Vector3D p = h->vertex()->position;
  const Vector3D normal =
      cross(h->next()->vertex()->position - p, h->next()->next()->vertex()->position - p);
  if (normal.norm() == 0.0) return {};
  const Vector3D n = normal.unit();
  const double d = -dot(n, p);
  return {{n.x * n, n.y * n, n.z * n}, d * n, d * d};
}

// Where on the way from p to q the quadric is least.
Vector3D bestBetween(const ErrorQuadric& K, const Vector3D& p, const Vector3D& q) {
  const double start = K.at(p);
  const double middle = K.at(0.5 * (p + q));
  const double end = K.at(q);
  // With t from 0 to 1 it is start + slope t + curve t^2.
  const double curve = 2.0 * (start + end - 2.0 * middle);
  const double slope = end - start - curve;
  if (curve > 0.0) return p + std::min(1.0, std::max(0.0, -0.5 * slope / curve)) * (q - p);
  return start < end ? p : q;
}

// Where the quadric is least: A v = -b, by Cramer's rule. If that has no single solution (all
// is flat, or straight like a crease), the best point of the edge.
Vector3D bestPoint(const ErrorQuadric& K, EdgeIter e) {
  const Vector3D across = cross(K.A[1], K.A[2]);
  const double det = dot(K.A[0], across);
  const double size = K.A[0].x + K.A[1].y + K.A[2].z;
  if (det <= 1e-6 * size * size * size) {
    const HalfedgeIter h = e->halfedge();
    return bestBetween(K, h->vertex()->position, h->twin()->vertex()->position);
  }
  const Vector3D r = -K.b;
  return Vector3D(dot(r, across), dot(K.A[0], cross(r, K.A[2])),
                  dot(K.A[0], cross(K.A[1], r))) /
         det;
}

std::vector<EdgeIter> edgesAt(VertexIter v) {
  std::vector<EdgeIter> edges;
  HalfedgeIter h = v->halfedge();
  do {
    edges.push_back(h->edge());
    h = h->twin()->next();
  } while (h != v->halfedge());
  return edges;
}

// The edges that may be collapsed, the cheapest first.
class Candidates {
 public:
  explicit Candidates(PolyMesh& mesh) {
    for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
      ErrorQuadric sum;
      HalfedgeIter h = v->halfedge();
      do {
        if (!h->isBoundary()) sum = sum + quadricOf(h->face());
        h = h->twin()->next();
      } while (h != v->halfedge());
      quadrics_[v] = sum;
    }
    for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e)
      add(e);
  }

  bool empty() const { return order_.empty(); }
  EdgeIter cheapest() const { return order_.begin()->second; }
  Vector3D bestPointOf(EdgeIter e) const { return bestPoint(quadricOfEdge(e), e); }

  ErrorQuadric quadricOfEdge(EdgeIter e) const {
    const HalfedgeIter h = e->halfedge();
    return quadrics_.at(h->vertex()) + quadrics_.at(h->twin()->vertex());
  }

  void remove(EdgeIter e) {
    const auto known = costs_.find(e);
    if (known == costs_.end()) return;
    order_.erase({known->second, e});
    costs_.erase(known);
  }

  // A vertex has moved: the edges at it cost something else now.
  void update(VertexIter v, const ErrorQuadric& K) {
    quadrics_[v] = K;
    for (EdgeIter e : edgesAt(v)) {
      remove(e);
      add(e);
    }
  }

 private:
  void add(EdgeIter e) {
    const ErrorQuadric K = quadricOfEdge(e);
    const double cost = K.at(bestPoint(K, e));
    costs_[e] = cost;
    order_.insert({cost, e});
  }

  std::map<VertexIter, ErrorQuadric> quadrics_;
  std::map<EdgeIter, double> costs_;  // of the edges in order_
  std::set<std::pair<double, EdgeIter>> order_;
};

}  // namespace
// SOLUTION END

// EXERCISE simplification: fewer triangles, where they are missed least.
//
//        . --- . --- .            . --- . --- .
//       / \   / \   / \          / \    |    / \         the edge a-b became the vertex v:
//      . --- a --- b --- .      .  ---  v  ---  .        two triangles less
//       \   / \   / \   /        \ /    |    \ /
//        . --- . --- .            . --- . --- .
//
// Collapse the edge of the least cost, again and again, until at most ratio times as many faces
// are left as there were. collapseEdge() is yours, from the exercise before; it puts the vertex
// in the middle, and you move it to the best point.
//
//   - A face has the quadric K of its plane: v^T K v is the squared distance of v from it.
//   - A vertex has the sum of those of its faces, an edge the sum of those of its two ends.
//   - The best point of an edge is where its quadric is least, and its cost the value there.
//   - The vertex that is left gets the quadric of the edge. The edges at it cost something else
//     then. Which edges go is known only before the collapse.
//   - An edge that collapseEdge() refuses is passed over, and is tried again when an end moves.
//
// Returns false if no collapse is left before the goal is reached.
bool PolyMesh::simplify(double ratio) {
  // SOLUTION BEGIN PolyMesh::simplify
  const double goal = ratio * static_cast<double>(nFaces());
  Candidates candidates(*this);
  while (static_cast<double>(nFaces()) > goal) {
    if (candidates.empty()) return false;
    const EdgeIter e = candidates.cheapest();
    candidates.remove(e);
    const ErrorQuadric K = candidates.quadricOfEdge(e);
    const Vector3D best = candidates.bestPointOf(e);
    std::vector<EdgeIter> around;  // some of them go
    for (VertexIter end : {e->halfedge()->vertex(), e->halfedge()->twin()->vertex()}) {
      for (EdgeIter other : edgesAt(end))
        around.push_back(other);
    }
    const std::optional<VertexIter> left = collapseEdge(e);
    if (!left) continue;
    (*left)->position = best;
    for (EdgeIter other : around)
      candidates.remove(other);
    candidates.update(*left, K);
  }
  return true;
  // SOLUTION END
}

}  // namespace meshedit
