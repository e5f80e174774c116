#include "tests/bench/workload.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "grader/subdivide/direct_catmull_clark.h"
#include "grader/subdivide/direct_loop.h"

namespace meshgrade::bench {
namespace {

PolygonMesh icosahedron() {
  constexpr double g = std::numbers::phi;
  PolygonMesh mesh;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.polygons = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                   {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                   {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                   {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

PolygonMesh cube() {
  PolygonMesh mesh;
  mesh.positions = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                    {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
  mesh.polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

PolygonMesh on_sphere(PolygonMesh mesh) {
  for (Point3& p : mesh.positions) {
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& coordinate : p)
      coordinate /= length;
  }
  return mesh;
}

PolygonMesh sphere(unsigned levels) {
  SubdivisionOptions options;
  options.levels = levels;
  return on_sphere(direct_loop(icosahedron(), options));
}

PolygonMesh sphere_of_quadrilaterals(unsigned levels) {
  SubdivisionOptions options;
  options.levels = levels;
  return on_sphere(direct_catmull_clark(cube(), options));
}

/// The numbers 0 .. n - 1 in random order, the same in every run.
std::vector<std::uint32_t> random_order(std::size_t n) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), std::mt19937_64{n});
  return order;
}

/// Edges of triangles that have no corner in common, so that no flip spoils another.
std::vector<std::array<std::uint32_t, 2>> choose_edges(const PolygonMesh& mesh) {
  std::vector<bool> taken(mesh.positions.size(), false);
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const std::uint32_t f : random_order(mesh.polygons.size())) {
    const auto& corners = mesh.polygons[f];
    if (std::any_of(corners.begin(), corners.end(), [&](auto v) { return taken[v]; })) continue;
    for (const std::uint32_t v : corners)
      taken[v] = true;
    edges.push_back({f, f % 3});
  }
  return edges;
}

Workload with_edges(PolygonMesh mesh) {
  Workload workload;
  workload.edges = choose_edges(mesh);
  workload.mesh = std::move(mesh);
  return workload;
}

Workload shuffled(const PolygonMesh& ordered) {
  const auto new_vertex = random_order(ordered.positions.size());
  const auto new_face = random_order(ordered.polygons.size());
  PolygonMesh mesh = ordered;
  for (std::size_t v = 0; v < new_vertex.size(); ++v)
    mesh.positions[new_vertex[v]] = ordered.positions[v];
  for (std::size_t f = 0; f < new_face.size(); ++f) {
    auto& corners = mesh.polygons[new_face[f]];
    corners = ordered.polygons[f];
    for (std::uint32_t& v : corners)
      v = new_vertex[v];
  }
  return with_edges(std::move(mesh));
}

}  // namespace

Workload icosphere(unsigned levels) {
  return with_edges(sphere(levels));
}

Workload shuffled_icosphere(unsigned levels) {
  return shuffled(sphere(levels));
}

Workload cube_sphere(unsigned levels) {
  return with_edges(sphere_of_quadrilaterals(levels));
}

Workload shuffled_cube_sphere(unsigned levels) {
  return shuffled(sphere_of_quadrilaterals(levels));
}

}  // namespace meshgrade::bench
