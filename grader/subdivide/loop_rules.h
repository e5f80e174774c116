#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "grader/mesh/polygon_mesh.h"
#include "grader/subdivide/subdivision_rules.h"

namespace meshgrade {

/// The weight b of each neighbour of an interior vertex of `valence` >= 3.
inline double neighbour_weight(VertexRule rule, std::size_t valence) {
  const double n = static_cast<double>(valence);
  if (rule == VertexRule::kWarren) return valence == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * n);
  const double c = 3.0 / 8.0 + std::cos(2.0 * std::numbers::pi / n) / 4.0;
  return (5.0 / 8.0 - c * c) / n;
}

inline constexpr const char* kLoopNeeds = "Loop subdivision needs a manifold of triangles";

/// @return the mesh. @throws SubdivisionError that names a polygon which is no triangle
inline const PolygonMesh& require_triangles(const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    const std::size_t size = mesh.polygons[f].size();
    if (size == 3) continue;
    throw SubdivisionError("face f" + std::to_string(f) + " has " + std::to_string(size) +
                           " corners; " + kLoopNeeds);
  }
  return mesh;
}

}  // namespace meshgrade
