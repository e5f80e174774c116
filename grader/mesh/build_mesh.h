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

constexpr std::uint32_t kAnchorWays = 6;  ///< of anchor_on()

/// Changes what the elements around an edge anchor: as right as what build() gives, and harder
/// for a solution that forgets an anchor. Only vertices inside: those on a boundary keep their
/// boundary half-edge, so that this alone is not what most points of a solution that counts on
/// it depend on. The mesh must be right.
///
/// @param way  the face on each side, and where that starts, anchor the edge's own half-edge (0
///             and 3), the next one (1, 4) or the one after that (2, 5). Below 3 the edge
///             anchors the other of its half-edges; from 3 on it stays.
inline void anchor_on(meshedit::EdgeIter edge, std::uint32_t way = 0) {
  if (way < kAnchorWays / 2) edge->halfedge() = edge->halfedge()->twin();
  const meshedit::HalfedgeIter h = edge->halfedge();
  for (meshedit::HalfedgeIter side : {h, h->twin()}) {
    for (std::uint32_t i = 0; i < way % 3; ++i)
      side = side->next();
    side->face()->halfedge() = side;
    if (!side->vertex()->isBoundary()) side->vertex()->halfedge() = side;
  }
}

/// Makes each edge anchor the half-edge that starts at the earlier of its ends: so at the last
/// vertex, whose edges a subdivision meets late, none starts that an edge anchors.
inline void anchor_from_earlier(meshedit::HalfedgeMesh& mesh) {
  for (auto e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    const meshedit::HalfedgeIter twin = e->halfedge()->twin();
    if (twin->vertex() < e->halfedge()->vertex()) e->halfedge() = twin;
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
