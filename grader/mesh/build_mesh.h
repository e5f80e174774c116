#pragma once

#include "grader/mesh/polygon_mesh.h"
#include "meshedit/halfedge_mesh.h"

namespace meshgrade {

/// Builds a half-edge mesh. Written for C++17.
/// @throws meshedit::MeshError if the polygons are no surface
inline void build_mesh(const PolygonMesh& polygons, meshedit::HalfedgeMesh& mesh) {
  std::vector<std::vector<meshedit::Index>> corners;
  corners.reserve(polygons.polygons.size());
  for (const auto& polygon : polygons.polygons) {
    corners.emplace_back(polygon.begin(), polygon.end());
  }
  std::vector<meshedit::Vector3D> positions;
  positions.reserve(polygons.positions.size());
  for (const Point3& p : polygons.positions)
    positions.emplace_back(p[0], p[1], p[2]);
  mesh.build(corners, positions);
}

/// Makes the elements around an edge anchor its half-edges, and the edge the other of its two:
/// as right as what build() gives, and harder for a solution that forgets an anchor. Only
/// vertices inside: those on a boundary keep their boundary half-edge, so that this alone is
/// not what most points of a solution that counts on it depend on. The mesh must be right.
inline void anchor_on(meshedit::EdgeIter edge) {
  const meshedit::HalfedgeIter h = edge->halfedge()->twin();
  edge->halfedge() = h;
  for (const meshedit::HalfedgeIter& side : {h, h->twin()}) {
    side->face()->halfedge() = side;
    if (!side->vertex()->isBoundary()) side->vertex()->halfedge() = side;
  }
}

/// Makes every element anchor another half-edge than as it was built, the next one around. Just
/// as right: flips and splits leave such meshes behind. The mesh must be right.
inline void anchor_elsewhere(meshedit::HalfedgeMesh& mesh) {
  for (auto v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v)
    v->halfedge() = v->halfedge()->twin()->next();
  for (auto e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e)
    e->halfedge() = e->halfedge()->twin();
  for (auto f = mesh.facesBegin(); f != mesh.facesEnd(); ++f)
    f->halfedge() = f->halfedge()->next();
  for (auto b = mesh.boundariesBegin(); b != mesh.boundariesEnd(); ++b)
    b->halfedge() = b->halfedge()->next();
}

}  // namespace meshgrade
