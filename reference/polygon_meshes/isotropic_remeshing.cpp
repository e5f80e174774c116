#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

std::vector<EdgeIter> edgesOf(PolyMesh& mesh) {
  std::vector<EdgeIter> edges;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e)
    edges.push_back(e);
  return edges;
}

double meanLength(PolyMesh& mesh) {
  double sum = 0.0;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e)
    sum += e->length();
  return sum / static_cast<double>(mesh.nEdges());
}

std::vector<HalfedgeIter> spokesOf(VertexIter v) {
  std::vector<HalfedgeIter> spokes;
  HalfedgeIter h = v->halfedge();
  do {
    spokes.push_back(h);
    h = h->twin()->next();
  } while (h != v->halfedge());
  return spokes;
}

void splitLongEdges(PolyMesh& mesh, double longest) {
  for (EdgeIter e : edgesOf(mesh)) {
    if (e->length() > longest) mesh.splitEdge(e);
  }
}

// A collapse deletes the edge, and of each triangle beside it one of the two other sides. Which
// one is seen afterwards: what is left lies at the vertex that is left.
void collapseShortEdges(PolyMesh& mesh, double shortest) {
  std::set<EdgeIter> gone;
  for (EdgeIter e : edgesOf(mesh)) {
    if (gone.count(e) != 0 || e->length() >= shortest) continue;
    std::set<EdgeIter> beside{e};
    for (HalfedgeIter h : {e->halfedge(), e->halfedge()->twin()}) {
      if (h->isBoundary()) continue;
      beside.insert(h->next()->edge());
      beside.insert(h->next()->next()->edge());
    }
    const std::optional<VertexIter> left = mesh.collapseEdge(e);
    if (!left) continue;
    for (HalfedgeIter spoke : spokesOf(*left))
      beside.erase(spoke->edge());
    gone.insert(beside.begin(), beside.end());
  }
}

// How far a vertex is from six edges, with so many more.
int deviation(VertexIter v, int more) {
  return std::abs(static_cast<int>(spokesOf(v).size()) + more - 6);
}

void flipForValence(PolyMesh& mesh) {
  for (EdgeIter e : edgesOf(mesh)) {
    if (e->isBoundary()) continue;
    const HalfedgeIter h = e->halfedge();
    const HalfedgeIter t = h->twin();
    const VertexIter a = h->vertex();
    const VertexIter b = t->vertex();
    const VertexIter c = h->next()->next()->vertex();
    const VertexIter d = t->next()->next()->vertex();
    const int before = deviation(a, 0) + deviation(b, 0) + deviation(c, 0) + deviation(d, 0);
    const int after = deviation(a, -1) + deviation(b, -1) + deviation(c, 1) + deviation(d, 1);
    if (after < before) mesh.flipEdge(e);
  }
}

// Where a vertex inside of the surface goes. Each cross product is along the normal of a
// triangle, and as long as twice its area.
Vector3D smoothed(VertexIter v, double step) {
  const Vector3D p = v->position;
  const std::vector<HalfedgeIter> spokes = spokesOf(v);
  Vector3D normal;
  Vector3D mean;
  for (HalfedgeIter h : spokes) {
    const Vector3D q = h->twin()->vertex()->position;
    const Vector3D r = h->next()->next()->vertex()->position;
    normal += cross(q - p, r - p);
    mean += q / static_cast<double>(spokes.size());
  }
  normal.normalize();
  const Vector3D u = mean - p;
  return p + step * (u - dot(u, normal) * normal);
}

void smooth(PolyMesh& mesh, double step) {
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v)
    v->newPosition = v->isBoundary() ? v->position : smoothed(v, step);
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v)
    v->position = v->newPosition;
}

}  // namespace
// SOLUTION END

// EXERCISE isotropic_remeshing: make the triangles of a mesh alike.
//
//      x ------- x             x ------- x
//      | `-.  .-'|             | \     / |          1. split what is too long
//      |   .xx   |             |  \   /  |          2. collapse what is too short
//      | .'   `-.|             |    x    |          3. flip towards six edges at each vertex
//      x ------- x             x ------- x          4. smooth along the surface
//
// In each round L is the mean length of the edges: too long is what exceeds longerFactor L,
// too short what is below shorterFactor L. An edge is flipped if that lowers the sum of |n - 6|
// over the four vertices of its two triangles, n being the number of edges at a vertex.
//
// To smooth, each vertex p goes to p + step (u - (u . N) N): u leads to the mean of its
// neighbours, N is its unit normal, weighted by areas. All of them from the positions before.
//
// Splits add to the list of edges that you walk over, collapses take from it: which edges are
// gone after one? Call your own splitEdge, collapseEdge and flipEdge; a collapse or a flip may
// be refused.
void PolyMesh::isotropicRemesh(const RemeshParameters& parameters) {
  // SOLUTION BEGIN PolyMesh::isotropicRemesh
  for (Size round = 0; round < parameters.outerIterations; ++round) {
    const double mean = meanLength(*this);
    splitLongEdges(*this, parameters.longerFactor * mean);
    collapseShortEdges(*this, parameters.shorterFactor * mean);
    flipForValence(*this);
    for (Size i = 0; i < parameters.smoothingIterations; ++i)
      smooth(*this, parameters.smoothingStep);
  }
  // SOLUTION END
}

}  // namespace meshedit
