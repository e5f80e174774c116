#pragma once

// What the weights of Loop subdivision are applied to: the neighbours of a vertex and the
// vertices opposite an edge.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "grader/judge/loop_misconceptions.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

inline void add_weighted(Point3& sum, const Point3& p, double weight) {
  for (std::size_t i = 0; i < 3; ++i)
    sum[i] += weight * p[i];
}

/// Who is next to whom in the mesh before the step.
class Neighbourhoods {
 public:
  explicit Neighbourhoods(const PolygonMesh& mesh)
      : positions(mesh.positions),
        neighbours(mesh.positions.size()),
        on_boundary(mesh.positions.size(), false) {
    for (const auto& t : mesh.polygons) {
      for (std::size_t i = 0; i < 3; ++i) {
        opposite_[std::minmax(t[i], t[(i + 1) % 3])].push_back(t[(i + 2) % 3]);
      }
    }
    for (const auto& [edge, opposite] : opposite_) {
      neighbours[edge.first].push_back(edge.second);
      neighbours[edge.second].push_back(edge.first);
      if (opposite.size() > 1) continue;
      on_boundary[edge.first] = on_boundary[edge.second] = true;
    }
  }

  const std::vector<std::uint32_t>& opposite(const Origin& edge) const {
    return opposite_.at(std::minmax(edge.a, edge.b));
  }

  /// (1 - n u) v + u (sum of the neighbours), from these positions.
  Point3 smoothed(std::uint32_t v, double n, double u, const std::vector<Point3>& from) const {
    Point3 sum{};
    add_weighted(sum, from[v], 1.0 - n * u);
    for (std::uint32_t w : neighbours[v])
      add_weighted(sum, from[w], u);
    return sum;
  }

  /// 3/4 v + 1/8 (the two neighbours along the boundary), from these positions.
  Point3 smoothed_on_boundary(std::uint32_t v, const std::vector<Point3>& from) const {
    Point3 sum{};
    add_weighted(sum, from[v], 0.75);
    for (std::uint32_t w : neighbours[v]) {
      if (opposite({v, w}).size() == 1) add_weighted(sum, from[w], 0.125);
    }
    return sum;
  }

  /// 3/4 v + 1/8 (every neighbour on a boundary), whether or not the edge to it lies there.
  Point3 smoothed_by_boundary_vertices(std::uint32_t v) const {
    Point3 sum{};
    add_weighted(sum, positions[v], 0.75);
    for (std::uint32_t w : neighbours[v]) {
      if (on_boundary[w]) add_weighted(sum, positions[w], 0.125);
    }
    return sum;
  }

  /// Weights for the ends of an edge and for the vertices opposite, from these positions.
  Point3 edge_point(const Origin& edge, double ends, double opposites,
                    const std::vector<Point3>& from) const {
    Point3 sum{};
    add_weighted(sum, from[edge.a], ends);
    add_weighted(sum, from[edge.b], ends);
    for (std::uint32_t v : opposite(edge))
      add_weighted(sum, from[v], opposites);
    return sum;
  }

  std::vector<Point3> positions;
  std::vector<std::vector<std::uint32_t>> neighbours;
  std::vector<bool> on_boundary;

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> opposite_;
};

}  // namespace meshgrade
