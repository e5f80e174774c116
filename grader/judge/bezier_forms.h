#pragma once

// Bezier curves in closed form, to judge de Casteljau's algorithm by another way of computing.

#include <cstddef>
#include <vector>

namespace meshgrade {

/// (1 - t) a + t b, coordinate by coordinate.
template <class Point>
Point blend(const Point& a, const Point& b, double t) {
  Point p{};
  for (std::size_t i = 0; i < p.size(); ++i)
    p[i] = (1.0 - t) * a[i] + t * b[i];
  return p;
}

/// One level of de Casteljau's algorithm.
template <class Point>
std::vector<Point> de_casteljau_step(const std::vector<Point>& points, double t) {
  std::vector<Point> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back(blend(points[i], points[i + 1], t));
  }
  return next;
}

/// The point at t by the Bernstein form: the sum of C(n, i) (1 - t)^(n - i) t^i points[i].
template <class Point>
Point bernstein(const std::vector<Point>& points, double t) {
  const std::size_t n = points.size() - 1;
  Point sum{};
  for (std::size_t i = 0; i <= n; ++i) {
    double weight = 1.0;
    for (std::size_t k = 0; k < i; ++k) {
      weight *= t * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    for (std::size_t k = i; k < n; ++k)
      weight *= 1.0 - t;
    for (std::size_t axis = 0; axis < sum.size(); ++axis)
      sum[axis] += weight * points[i][axis];
  }
  return sum;
}

}  // namespace meshgrade
