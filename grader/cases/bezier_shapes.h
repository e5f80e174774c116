#pragma once

// Control points for which the answer is known from that of others, and the parameters that
// tell most.

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "grader/base/random.h"

namespace meshgrade {

/// The budget of a case on curves and patches, which have no handles to step through.
inline constexpr std::uint64_t kNoSteps = 1000;

/// Eighths, and a value near each end: all of them numbers that a float can hold.
inline constexpr std::array<double, 9> kParameterGrid{
    0.25, 0.75, 1.0 / 1024.0, 1.0 - 1.0 / 1024.0, 0.125, 0.375, 0.5, 0.625, 0.875};

/// Points whose coordinates are multiples of 1/1024 from -4 to 4: the same in float, also far
/// from the origin.
template <class Point>
std::vector<Point> points_on_grid(std::size_t count, Random& random) {
  std::vector<Point> points(count);
  for (Point& p : points) {
    for (double& x : p)
      x = (static_cast<double>(random.below(8193)) - 4096.0) / 1024.0;
  }
  return points;
}

/// Control points under a map, and what to call that.
template <class Point>
struct MovedPoints {
  std::string how;
  std::vector<Point> points;
};

/// The points scaled by 1e-6, 1e-2, 10 and 1e6, far from the origin, turned, mirrored, and with
/// the first of them at the origin.
template <class Point>
std::vector<MovedPoints<Point>> moved_points(const std::vector<Point>& points) {
  const auto map = [&](auto change) {
    std::vector<Point> moved = points;
    for (Point& p : moved)
      change(p);
    return moved;
  };
  const auto scaled = [&](double factor) {
    return map([&](Point& p) {
      for (double& x : p)
        x *= factor;
    });
  };
  return {{"1,000,000 times smaller", scaled(1e-6)},
          {"100 times smaller", scaled(1e-2)},
          {"10 times larger", scaled(10.0)},
          {"1,000,000 times larger", scaled(1e6)},
          {"far from the origin", map([](Point& p) {
             for (std::size_t i = 0; i < p.size(); ++i)
               p[i] += i % 2 == 0 ? 96.0 : -64.0;
           })},
          {"turned", map([](Point& p) {
             const double x = 0.8 * p[0] - 0.6 * p[1];
             p[1] = 0.6 * p[0] + 0.8 * p[1];
             p[0] = x;
           })},
          {"mirrored", map([](Point& p) { p[0] = -p[0]; })},
          {"with a point at the origin", map([first = points.at(0)](Point& p) {
             for (std::size_t i = 0; i < p.size(); ++i)
               p[i] -= first[i];
           })}};
}

}  // namespace meshgrade
