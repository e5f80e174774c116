#include "grader/judge/local_scale.h"

#include <algorithm>
#include <cmath>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

/// The largest coordinate of a point.
double reach(const Point3& p) {
  return std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
}

/// The edges around one old vertex.
struct Ring {
  double lengths = 0.0;
  double count = 0.0;
  double reach = 0.0;  ///< the largest coordinate around
};

/// Edges inside count twice, from the two triangles: a boundary weighs less, which is near
/// enough.
std::vector<Ring> rings_of(const PolygonMesh& mesh) {
  std::vector<Ring> rings(mesh.positions.size());
  for (const auto& t : mesh.polygons) {
    for (std::size_t i = 0; i < t.size(); ++i) {
      const std::uint32_t from = t[i];
      const std::uint32_t to = t[(i + 1) % t.size()];
      const double length = distance(mesh.positions[from], mesh.positions[to]);
      const double far = std::max(reach(mesh.positions[from]), reach(mesh.positions[to]));
      for (std::uint32_t v : {from, to}) {
        rings[v].lengths += length;
        rings[v].count += 1.0;
        rings[v].reach = std::max(rings[v].reach, far);
      }
    }
  }
  return rings;
}

}  // namespace

std::string error_text(double error, const LocalScale& scale) {
  if (scale.length <= 0.0) return number_text(error, 2) + ", and " + scale.what + " is 0";
  return number_text(error / scale.length, 2) + " of " + scale.what +
         " (allowed: " + number_text(scale.allowed / scale.length, 2) + ")";
}

LocalScale scale_of_edge(const Point3& a, const Point3& b, double tolerance) {
  const double length = distance(a, b);
  return {length, tolerance * length + float_rounding(std::max(reach(a), reach(b))),
          "the length of the edge"};
}

std::vector<LocalScale> scales_of_level(const PolygonMesh& old,
                                        const std::vector<Origin>& origins, double tolerance) {
  const std::vector<Ring> rings = rings_of(old);
  std::vector<LocalScale> scales;
  for (const Origin& origin : origins) {
    const Ring& ring = rings[origin.a];
    LocalScale scale;
    if (origin.is_old()) {
      scale.length = ring.lengths / ring.count;
      scale.what = "the mean length of its edges before the step";
    } else {
      scale.length = distance(old.positions[origin.a], old.positions[origin.b]);
      scale.what = "the length of the old edge";
    }
    scale.allowed =
        tolerance * scale.length + float_rounding(std::max(ring.reach, rings[origin.b].reach));
    scales.push_back(scale);
  }
  return scales;
}

std::vector<LocalScale> scales_of_normals(const PolygonMesh& mesh, double tolerance) {
  std::vector<LocalScale> scales;
  for (const Ring& ring : rings_of(mesh)) {
    const double length = ring.lengths / ring.count;
    const double turned = length > 0.0 ? float_rounding(ring.reach) / length : 0.0;
    scales.push_back({1.0, tolerance + turned, "its length"});
  }
  return scales;
}

bool are_within(const std::vector<Point3>& expected, const std::vector<Point3>& actual,
                const std::vector<LocalScale>& scales) {
  for (std::size_t i = 0; i < actual.size(); ++i) {
    if (!(distance(expected[i], actual[i]) <= scales[i].allowed)) return false;
  }
  return true;
}

WorstPoint worst_by_scale(const std::vector<Point3>& expected,
                          const std::vector<Point3>& actual,
                          const std::vector<LocalScale>& scales) {
  WorstPoint worst;
  double most = 0.0;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const double error = distance(expected[i], actual[i]);
    if (error <= most * scales[i].allowed) continue;
    most = error / scales[i].allowed;
    worst = {i, error};
  }
  return worst;
}

}  // namespace meshgrade
