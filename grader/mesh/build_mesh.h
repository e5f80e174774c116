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

}  // namespace meshgrade
