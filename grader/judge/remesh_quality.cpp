#include "grader/judge/remesh_quality.h"

#include <algorithm>
#include <cmath>

#include "grader/judge/point_compare.h"

namespace meshgrade {
namespace {

Point3 point_between(const Point3& a, const Point3& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

double scalar_product(const Point3& o, const Point3& a, const Point3& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += (a[i] - o[i]) * (b[i] - o[i]);
  return sum;
}

double distance_to_segment(const Point3& a, const Point3& b, const Point3& p) {
  const double length2 = scalar_product(a, b, b);
  const double t = length2 > 0.0 ? scalar_product(a, b, p) / length2 : 0.0;
  return distance(p, point_between(a, b, std::clamp(t, 0.0, 1.0)));
}

/// To the foot of the perpendicular, if that lies within; otherwise to the nearest side.
double distance_to_triangle(const Point3& a, const Point3& b, const Point3& c,
                            const Point3& p) {
  const double bb = scalar_product(a, b, b);
  const double bc = scalar_product(a, b, c);
  const double cc = scalar_product(a, c, c);
  const double pb = scalar_product(a, p, b);
  const double pc = scalar_product(a, p, c);
  const double area = bb * cc - bc * bc;
  const double s = (pb * cc - pc * bc) / area;
  const double t = (pc * bb - pb * bc) / area;
  if (s >= 0.0 && t >= 0.0 && s + t <= 1.0) {
    const Point3 foot{a[0] + s * (b[0] - a[0]) + t * (c[0] - a[0]),
                      a[1] + s * (b[1] - a[1]) + t * (c[1] - a[1]),
                      a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2])};
    return distance(p, foot);
  }
  return std::min({distance_to_segment(a, b, p), distance_to_segment(b, c, p),
                   distance_to_segment(c, a, p)});
}

}  // namespace

MeshQuality quality_of(const MeshDump& mesh) {
  std::vector<double> lengths;
  std::vector<int> valences(mesh.vertices.size(), 0);
  for (const EdgeRecord& e : mesh.edges) {
    if (e.live == 0) continue;
    const Ref a = mesh.halfedges[e.halfedge].vertex;
    const Ref b = mesh.halfedges[mesh.halfedges[e.halfedge].twin].vertex;
    lengths.push_back(distance(mesh.vertices[a].position, mesh.vertices[b].position));
    ++valences[a];
    ++valences[b];
  }
  MeshQuality quality;
  const auto n = static_cast<double>(lengths.size());
  for (const double length : lengths)
    quality.mean_length += length / n;
  double squares = 0.0;
  for (const double length : lengths)
    squares += std::pow(length - quality.mean_length, 2) / n;
  quality.variation = std::sqrt(squares) / quality.mean_length;
  double vertices = 0.0;
  for (Ref v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].live == 0) continue;
    vertices += 1.0;
    quality.deviation += std::abs(valences[v] - 6);
  }
  quality.deviation /= vertices;
  return quality;
}

double distance_to(const FaceLists& triangles, const Point3& point) {
  double least = INFINITY;
  for (const Corners& t : triangles.faces) {
    least = std::min(least,
                     distance_to_triangle(triangles.positions[t[0]], triangles.positions[t[1]],
                                          triangles.positions[t[2]], point));
  }
  return least;
}

}  // namespace meshgrade
