#pragma once

// Compares what is numbered by arithmetic with what OpenSubdiv numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "grader/subdivide/opensubdiv_level.h"

namespace meshgrade {

inline double largest_coordinate(const PolygonMesh& mesh) {
  double largest = 0;
  for (const Point3& point : mesh.positions) {
    for (const double x : point)
      largest = std::max(largest, std::abs(x));
  }
  return largest;
}

/// The faces, each begun at its lowest vertex, under new names.
inline std::multiset<std::vector<std::uint32_t>> renamed_faces(
    const PolygonMesh& mesh, const std::vector<std::uint32_t>* names) {
  std::multiset<std::vector<std::uint32_t>> faces;
  for (std::vector<std::uint32_t> face : mesh.polygons) {
    if (names) {
      for (std::uint32_t& v : face)
        v = (*names)[v];
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.insert(face);
  }
  return faces;
}

/// The point of each edge, by its ends, the lower one first.
inline std::map<std::array<std::uint32_t, 2>, std::uint32_t> children_of_edges(
    const SubdivisionLevel& level) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> children;
  for (std::size_t e = 0; e < level.edges.size(); ++e) {
    const auto [a, b] = level.edges[e];
    children[{std::min(a, b), std::max(a, b)}] = level.child_of_edge[e];
  }
  return children;
}

/// Vertex v of `ours` lies where vertex names[v] of `theirs` does.
inline void expect_same_points(const PolygonMesh& ours, const PolygonMesh& theirs,
                               const std::vector<std::uint32_t>& names) {
  const double tolerance = 1e-12 * largest_coordinate(theirs);
  for (std::size_t v = 0; v < ours.positions.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_NEAR(ours.positions[v][axis], theirs.positions[names[v]][axis], tolerance)
          << "vertex v" << v;
    }
  }
}

}  // namespace meshgrade
