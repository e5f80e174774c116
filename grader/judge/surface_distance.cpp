#include "grader/judge/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "grader/mesh/point_products.h"

namespace meshgrade {
namespace {

Point3 way(const Point3& from, const Point3& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

double squared_distance_from_segment(const Point3& point, const Point3& p, const Point3& q) {
  const Point3 along = way(p, q);
  const Point3 out = way(p, point);
  const double squared = dot(along, along);
  const double t = squared > 0.0 ? std::clamp(dot(out, along) / squared, 0.0, 1.0) : 0.0;
  const Point3 rest{out[0] - t * along[0], out[1] - t * along[1], out[2] - t * along[2]};
  return dot(rest, rest);
}

/// Over the triangle if both barycentric coordinates say so, else from its sides.
double squared_distance(const Point3& point, const Point3& p, const Point3& q,
                        const Point3& r) {
  const Point3 u = way(p, q);
  const Point3 v = way(p, r);
  const Point3 w = way(p, point);
  const double uu = dot(u, u);
  const double uv = dot(u, v);
  const double vv = dot(v, v);
  const double det = uu * vv - uv * uv;
  if (det > 0.0) {
    const double s = (vv * dot(w, u) - uv * dot(w, v)) / det;
    const double t = (uu * dot(w, v) - uv * dot(w, u)) / det;
    if (s >= 0.0 && t >= 0.0 && s + t <= 1.0) {
      const Point3 rest{w[0] - s * u[0] - t * v[0], w[1] - s * u[1] - t * v[1],
                        w[2] - s * u[2] - t * v[2]};
      return dot(rest, rest);
    }
  }
  return std::min({squared_distance_from_segment(point, p, q),
                   squared_distance_from_segment(point, q, r),
                   squared_distance_from_segment(point, r, p)});
}

double squared_distance_from(const Point3& point, const FaceLists& surface) {
  double least = INFINITY;
  for (const Corners& face : surface.faces) {
    least = std::min(
        least, squared_distance(point, surface.positions[face[0]], surface.positions[face[1]],
                                surface.positions[face[2]]));
  }
  return least;
}

std::vector<Point3> corners_in_use(const FaceLists& surface) {
  std::set<Label> labels;
  for (const Corners& face : surface.faces)
    labels.insert(face.begin(), face.end());
  std::vector<Point3> points;
  for (const Label label : labels)
    points.push_back(surface.positions[label]);
  return points;
}

/// Its corners and the middles of its faces.
std::vector<Point3> sample(const FaceLists& surface) {
  std::vector<Point3> points = corners_in_use(surface);
  for (const Corners& face : surface.faces) {
    Point3 middle{};
    for (const Label corner : face) {
      for (std::size_t i = 0; i < 3; ++i)
        middle[i] += surface.positions[corner][i] / 3.0;
    }
    points.push_back(middle);
  }
  return points;
}

double mean_squared(const std::vector<Point3>& points, const FaceLists& surface) {
  double sum = 0.0;
  for (const Point3& point : points)
    sum += squared_distance_from(point, surface);
  return sum / static_cast<double>(points.size());
}

}  // namespace

double distance_from(const Point3& point, const FaceLists& surface) {
  return std::sqrt(squared_distance_from(point, surface));
}

double surface_distance(const FaceLists& one, const FaceLists& other) {
  return std::sqrt(
      std::max(mean_squared(sample(one), other), mean_squared(sample(other), one)));
}

double farthest_corner(const FaceLists& one, const FaceLists& other) {
  double most = 0.0;
  for (const Point3& point : corners_in_use(one))
    most = std::max(most, distance_from(point, other));
  return most;
}

}  // namespace meshgrade
