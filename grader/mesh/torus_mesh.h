#pragma once

#include <cmath>
#include <numbers>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// A torus of radii 2 and 3/4 around the y axis, of `around` x `across` squares with a diagonal
/// each: 2 * around * across triangles, every vertex of valence 6. Both numbers are at least 3.
/// torus_mesh(100, 100) is the large mesh of the course: 20000 triangles.
inline PolygonMesh torus_mesh(std::uint32_t around, std::uint32_t across) {
  constexpr double kTurn = 2 * std::numbers::pi;
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double a = kTurn * i / around;
      const double b = kTurn * j / across;
      const double radius = 2 + 0.75 * std::cos(b);
      mesh.positions.push_back(
          {radius * std::cos(a), 0.75 * std::sin(b), radius * std::sin(a)});
      const std::uint32_t here = i * across;
      const std::uint32_t there = (i + 1) % around * across;
      const std::uint32_t next = (j + 1) % across;
      mesh.polygons.push_back({here + j, there + next, there + j});
      mesh.polygons.push_back({here + j, here + next, there + next});
    }
  }
  return mesh;
}

}  // namespace meshgrade
