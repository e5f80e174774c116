#include "grader/cases/moved_meshes.h"

#include <algorithm>
#include <cmath>

namespace meshgrade {
namespace {

constexpr double kGrid = 1024.0;  // coordinates of shaken meshes are multiples of its inverse

Point3 plus(const Point3& p, const Point3& q, double factor) {
  return {p[0] + factor * q[0], p[1] + factor * q[1], p[2] + factor * q[2]};
}

PolygonMesh scaled(const PolygonMesh& mesh, double factor) {
  return mapped(mesh, [&](const Point3& p) { return plus({}, p, factor); });
}

PolygonMesh shifted(const PolygonMesh& mesh, const Point3& by, double factor) {
  return mapped(mesh, [&](const Point3& p) { return plus(p, by, factor); });
}

PolygonMesh turned(const PolygonMesh& mesh) {
  const double c = std::cos(2.0);
  const double s = std::sin(2.0);
  return mapped(mesh, [&](const Point3& p) {
    const double x = c * p[0] - s * p[2];
    const double z = s * p[0] + c * p[2];
    return Point3{0.8 * x + 0.6 * p[1], -0.6 * x + 0.8 * p[1], z};
  });
}

/// Left is right; the corners of each face run the other way, so that it keeps its outside.
MovedMesh mirrored(const PolygonMesh& mesh, VertexPair edge) {
  PolygonMesh other = mapped(mesh, [](const Point3& p) { return Point3{-p[0], p[1], p[2]}; });
  for (auto& polygon : other.polygons)
    std::reverse(polygon.begin() + 1, polygon.end());
  const PolygonMesh ordered = in_build_order(other);
  // Shaken vertices are where no other is.
  const auto place_of = [&](std::uint32_t v) {
    const auto& all = ordered.positions;
    return static_cast<std::uint32_t>(std::find(all.begin(), all.end(), other.positions[v]) -
                                      all.begin());
  };
  return {"mirrored", ordered, std::minmax(place_of(edge.first), place_of(edge.second))};
}

/// To coordinates of few bits.
PolygonMesh on_grid(const PolygonMesh& mesh) {
  const auto round = [](double x) { return std::round(kGrid * x) / kGrid; };
  return mapped(mesh, [&](const Point3& p) {
    return Point3{round(p[0]), round(p[1]), round(p[2])};
  });
}

void append(PolygonMesh& mesh, const PolygonMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (auto polygon : other.polygons) {
    for (std::uint32_t& corner : polygon)
      corner += first;
    mesh.polygons.push_back(std::move(polygon));
  }
}

}  // namespace

PolygonMesh shaken(const PolygonMesh& mesh, Random& random) {
  return on_grid(jittered(mesh, 0.2, random));
}

std::vector<MovedMesh> moved_meshes(const PolygonMesh& mesh, VertexPair edge) {
  const Point3 end = mesh.positions.at(edge.first);
  const Point3 ends = plus(end, mesh.positions.at(edge.second), 1.0);
  return {{"1,000,000 times smaller", scaled(mesh, 1e-6), edge, false},
          {"100 times smaller", scaled(mesh, 1e-2), edge, false},
          {"10 times larger", scaled(mesh, 10.0), edge, false},
          {"1,000,000 times larger", scaled(mesh, 1e6), edge, false},
          {"far from the origin", shifted(mesh, {64.0, -96.0, 80.0}, 1.0), edge},
          {"turned", turned(mesh), edge},
          mirrored(mesh, edge),
          {"with a vertex at the origin", shifted(mesh, end, -1.0), edge},
          {"with the middle of an edge at the origin", shifted(mesh, ends, -0.5), edge}};
}

PolygonMesh many_valences(std::uint32_t first, std::uint32_t last, Random& random) {
  PolygonMesh all;
  for (std::uint32_t n = first; n <= last; ++n) {
    const Point3 place{6.0 * (n % 4), 6.0 * (n / 4 % 4), 0.0};
    // Wider with more sides, so that these do not get too short for being shaken.
    const PolygonMesh wide = mapped(bipyramid(n), [](const Point3& p) {
      return Point3{2.0 * p[0], p[1], 2.0 * p[2]};
    });
    append(all, shifted(on_grid(jittered(wide, 0.05, random)), place, 1.0));
  }
  return all;
}

PolygonMesh open_fan(std::uint32_t n) {
  PolygonMesh mesh;
  mesh.positions.push_back({0.0, 0.0, 0.0});
  for (std::uint32_t i = 0; i <= n; ++i) {
    const double angle = 5.0 * i / n;  // not all the way round
    mesh.positions.push_back({2.0 * std::cos(angle), std::sin(angle), 0.25 * (i % 3)});
  }
  for (std::uint32_t i = 1; i <= n; ++i)
    mesh.polygons.push_back({0, i, i + 1});
  return in_build_order(mesh);
}

PolygonMesh open_grid(std::uint32_t n, Random& random) {
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t j = 0; j <= n; ++j)
      mesh.positions.push_back({double(i), 0.5 * double(j), 0.25 * double((i * j) % 3)});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t here = i * (n + 1) + j;
      const std::uint32_t there = here + n + 1;
      mesh.polygons.push_back({here, there, there + 1});
      mesh.polygons.push_back({here, there + 1, here + 1});
    }
  }
  return in_build_order(shaken(mesh, random));
}

PolygonMesh side_by_side(const PolygonMesh& left, const PolygonMesh& right) {
  PolygonMesh both = left;
  append(both, shifted(right, {8.0, 0.0, 0.0}, 1.0));
  return both;
}

PolygonMesh two_sizes(const PolygonMesh& small, const PolygonMesh& large, Random& random) {
  PolygonMesh both = shaken(small, random);
  append(both, scaled(shaken(large, random), 1000.0));
  return both;
}

}  // namespace meshgrade
