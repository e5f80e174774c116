#include "grader/judge/quadric_error.h"

#include <cmath>

#include "grader/mesh/point_products.h"

namespace meshgrade {

double Quadric::at(const Point3& v) const {
  const Point3 av{a[0] * v[0] + a[1] * v[1] + a[2] * v[2],
                  a[1] * v[0] + a[3] * v[1] + a[4] * v[2],
                  a[2] * v[0] + a[4] * v[1] + a[5] * v[2]};
  return dot(v, av) + 2.0 * dot(b, v) + c;
}

Quadric operator+(const Quadric& p, const Quadric& q) {
  Quadric sum = p;
  for (std::size_t i = 0; i < sum.a.size(); ++i)
    sum.a[i] += q.a[i];
  for (std::size_t i = 0; i < sum.b.size(); ++i)
    sum.b[i] += q.b[i];
  sum.c += q.c;
  return sum;
}

Quadric operator*(double factor, const Quadric& q) {
  Quadric scaled = q;
  for (double& x : scaled.a)
    x *= factor;
  for (double& x : scaled.b)
    x *= factor;
  scaled.c *= factor;
  return scaled;
}

Point3 area_vector(const Point3& p, const Point3& q, const Point3& r) {
  return cross({q[0] - p[0], q[1] - p[1], q[2] - p[2]},
               {r[0] - p[0], r[1] - p[1], r[2] - p[2]});
}

Quadric plane_quadric(const Point3& p, const Point3& q, const Point3& r) {
  Point3 n = area_vector(p, q, r);
  const double length = std::hypot(n[0], n[1], n[2]);
  if (length == 0.0) return {};
  for (double& x : n)
    x /= length;
  const double d = -dot(n, p);
  return {{n[0] * n[0], n[0] * n[1], n[0] * n[2], n[1] * n[1], n[1] * n[2], n[2] * n[2]},
          {d * n[0], d * n[1], d * n[2]},
          d * d};
}

namespace {

/// The determinant of A, as a part of what it is for planes at right angles.
double relative_determinant(const Quadric& q) {
  const Point3 x{q.a[0], q.a[1], q.a[2]};
  const Point3 y{q.a[1], q.a[3], q.a[4]};
  const Point3 z{q.a[2], q.a[4], q.a[5]};
  const double mean = q.trace() / 3.0;
  return dot(x, cross(y, z)) / (mean * mean * mean);
}

}  // namespace

std::optional<Point3> least_point(const Quadric& q) {
  constexpr double kRounding = 1e-5;
  if (!(relative_determinant(q) > kRounding)) return {};
  const Point3 x{q.a[0], q.a[1], q.a[2]};
  const Point3 y{q.a[1], q.a[3], q.a[4]};
  const Point3 z{q.a[2], q.a[4], q.a[5]};
  const double det = dot(x, cross(y, z));
  const Point3 right{-q.b[0], -q.b[1], -q.b[2]};
  return Point3{dot(right, cross(y, z)) / det, dot(x, cross(right, z)) / det,
                dot(x, cross(y, right)) / det};
}

bool has_single_least_point(const Quadric& q) {
  // Solutions compare the determinant itself with some small number, or a part of it.
  constexpr double kSmall = 1e-6;
  constexpr double kSmallPart = 1e-2;
  const double mean = q.trace() / 3.0;
  const double part = relative_determinant(q);
  return part > kSmallPart && part * mean * mean * mean > kSmall;
}

}  // namespace meshgrade
