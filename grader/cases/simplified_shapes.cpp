#include "grader/cases/simplified_shapes.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "grader/cases/mesh_shapes.h"
#include "grader/mesh/torus_mesh.h"

namespace meshgrade {
namespace {

/// An octahedron, each of its triangles cut into 4 to the power of `times`, on the unit sphere.
PolygonMesh round_ball(std::uint32_t times) {
  PolygonMesh ball;
  ball.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  ball.polygons = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                   {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (std::uint32_t i = 0; i < times; ++i) {
    ball = mapped(cut_in_four(ball), [](const Point3& p) {
      const double length = std::hypot(p[0], p[1], p[2]);
      return Point3{p[0] / length, p[1] / length, p[2] / length};
    });
  }
  return ball;
}

Point3 with_bumps(const Point3& p) {
  const double r = 1.0 + 0.12 * std::sin(4.0 * p[0] + 1.0) * std::cos(3.0 * p[1]) +
                   0.08 * std::sin(5.0 * p[2]);
  return {r * p[0], r * p[1], r * p[2]};
}

Point3 rounded_box(const Point3& p) {
  const double norm = std::pow(std::pow(std::abs(p[0]), 8.0) + std::pow(std::abs(p[1]), 8.0) +
                                   std::pow(std::abs(p[2]), 8.0),
                               0.125);
  return {p[0] / norm, 1.5 * p[1] / norm, 0.75 * p[2] / norm};
}

Point3 with_waist(const Point3& p) {
  const double r = 0.35 + 0.65 * p[1] * p[1];
  return {r * p[0], 1.5 * p[1], r * p[2]};
}

/// The angle is bent, so that the triangles differ in size.
Point3 stretched(const Point3& p) {
  const double x = p[0] * std::abs(p[0]);
  const double rest = std::hypot(p[1], p[2]);
  const double factor = rest > 0.0 ? std::sqrt(1.0 - x * x) / rest : 0.0;
  return {2.0 * x, factor * p[1], 0.6 * factor * p[2]};
}

}  // namespace

PolygonMesh cut_to_triangles(const PolygonMesh& mesh) {
  PolygonMesh cut;
  cut.positions = mesh.positions;
  for (const auto& corners : mesh.polygons) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      cut.polygons.push_back({corners[0], corners[i], corners[i + 1]});
  }
  return cut;
}

PolygonMesh cut_in_four(const PolygonMesh& triangles) {
  PolygonMesh cut;
  cut.positions = triangles.positions;
  std::map<VertexPair, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [known, is_new] =
        middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(cut.positions.size()));
    if (is_new) {
      const Point3& p = triangles.positions[a];
      const Point3& q = triangles.positions[b];
      cut.positions.push_back({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])});
    }
    return known->second;
  };
  for (const auto& t : triangles.polygons) {
    const std::uint32_t ab = middle(t[0], t[1]);
    const std::uint32_t bc = middle(t[1], t[2]);
    const std::uint32_t ca = middle(t[2], t[0]);
    cut.polygons.push_back({t[0], ab, ca});
    cut.polygons.push_back({t[1], bc, ab});
    cut.polygons.push_back({t[2], ca, bc});
    cut.polygons.push_back({ab, bc, ca});
  }
  return in_build_order(cut);
}

PolygonMesh flat_patch(std::uint32_t n, Random& random) {
  const auto move = [&](double x) {
    return x + std::round(64.0 * random.between(-0.25, 0.25)) / 64.0;
  };
  return mapped(in_build_order(cut_to_triangles(quad_grid(n, n))), [&](const Point3& p) {
    const double x = move(p[0]);
    const double y = move(p[1]);
    return Point3{x, y, 0.5 * x + 0.25 * y + 1.0};
  });
}

PolygonMesh roof(std::uint32_t n) {
  const PolygonMesh grid = in_build_order(cut_to_triangles(quad_grid(2 * n, n)));
  return mapped(grid, [n](const Point3& p) {
    return Point3{p[0], p[1], 3.0 - 0.75 * std::abs(p[0] - double(n))};
  });
}

PolygonMesh hourglass() {
  const std::vector<double> radii{1.0, 1.5, 0.0625, 1.25, 0.75};
  PolygonMesh mesh;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / 3.0 + 0.3 * double(i);
      mesh.positions.push_back({radii[i] * std::cos(angle), radii[i] * std::sin(angle),
                                double(i) + 0.125 * radii[i] * j});
    }
  }
  for (std::uint32_t i = 0; i + 1 < radii.size(); ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      const std::uint32_t here = 3 * i + j;
      const std::uint32_t next = 3 * i + (j + 1) % 3;
      mesh.polygons.push_back({here, next, next + 3});
      mesh.polygons.push_back({here, next + 3, here + 3});
    }
  }
  const auto top = static_cast<std::uint32_t>(mesh.positions.size()) - 3;
  mesh.polygons.push_back({0, 2, 1});
  mesh.polygons.push_back({top, top + 1, top + 2});
  return in_build_order(mesh);
}

PolygonMesh winding_band(std::uint32_t n) {
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    const double angle = 0.7 * i;
    const double radius = 1.0 + 0.03 * i;
    const double x = radius * std::cos(angle);
    const double y = radius * std::sin(angle);
    const double z = 0.25 * i;
    const double tilt = 0.9 * std::sin(0.8 * i);
    for (const double side : {-0.03, 0.03})
      mesh.positions.push_back(
          {x + side * tilt * std::cos(angle), y + side * tilt * std::sin(angle), z + side});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t here = 2 * i;
    mesh.polygons.push_back({here, here + 2, here + 3});
    mesh.polygons.push_back({here, here + 3, here + 1});
  }
  return in_build_order(mesh);
}

const char* bumpy_shape_name(std::uint32_t which) {
  constexpr const char* kNames[kBumpyShapes] = {"a ball with bumps", "a ring with bumps",
                                                "a rounded box", "a body with a waist",
                                                "a stretched ball"};
  return kNames[which];
}

PolygonMesh bumpy_shape(std::uint32_t which) {
  switch (which) {
    case 0:
      return in_build_order(mapped(round_ball(4), with_bumps));
    case 1:
      return in_build_order(mapped(torus_mesh(32, 16), [](const Point3& p) {
        return Point3{p[0] + 0.1 * std::sin(3.0 * p[2]), p[1] + 0.15 * std::cos(2.0 * p[0]),
                      p[2]};
      }));
    case 2:
      return in_build_order(mapped(round_ball(4), rounded_box));
    case 3:
      return in_build_order(mapped(round_ball(4), with_waist));
    default:
      return in_build_order(mapped(round_ball(4), stretched));
  }
}

}  // namespace meshgrade
