#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace meshgrade {

/// The distance of two points; infinite if a coordinate is not a number.
template <class Point>
double distance(const Point& a, const Point& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::isfinite(sum) ? std::sqrt(sum) : INFINITY;
}

/// The length of the diagonal of the bounding box.
template <class Point>
double extent(const std::vector<Point>& points) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < Point().size(); ++axis) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(),
                            [&](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    sum += ((*high)[axis] - (*low)[axis]) * ((*high)[axis] - (*low)[axis]);
  }
  return std::sqrt(sum);
}

/// The largest coordinate of all.
template <class Point>
double largest_coordinate(const std::vector<Point>& points) {
  double most = 0.0;
  for (const Point& p : points) {
    for (double x : p)
      most = std::max(most, std::abs(x));
  }
  return most;
}

/// How far off a sum or mean may be that was computed in float from coordinates up to this one:
/// 32 times the rounding of one of them.
inline double float_rounding(double coordinate) {
  return std::ldexp(coordinate, -19);
}

/// The index at which two lists of points differ most, and by how much.
struct WorstPoint {
  std::size_t index = 0;
  double error = 0.0;
};

template <class Point>
WorstPoint worst_point(const std::vector<Point>& expected, const std::vector<Point>& actual) {
  WorstPoint worst;
  for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i) {
    const double error = distance(expected[i], actual[i]);
    if (error > worst.error) worst = {i, error};
  }
  return worst;
}

}  // namespace meshgrade
