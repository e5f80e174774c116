#pragma once

// What the Bezier exercises ask, as it goes to the worker. Written for C++17.

#include <array>
#include <cstdint>
#include <vector>

namespace meshgrade {

using Point2 = std::array<double, 2>;
using Point3 = std::array<double, 3>;

/// Steps of de Casteljau's algorithm on a plane curve.
struct CurveInput {
  std::vector<Point2> points;  ///< control points, at least 2
  double t = 0.0;              ///< a value that a float can hold
  std::uint32_t steps = 1;  ///< how often evaluateStep is called, each time on its last result

  template <class Wire>
  void transfer(Wire& wire) {
    wire(points, t, steps);
  }
};

/// What one call of evaluateStep gave.
struct CurveStep {
  std::vector<Point2> result;
  std::vector<Point2> input_after;  ///< the argument after the call
  std::uint32_t keeps_members = 1;  ///< 0 if a member of the curve is another than before

  template <class Wire>
  void transfer(Wire& wire) {
    wire(result, input_after, keeps_members);
  }
};

enum class PatchFunction : std::uint32_t { kStep = 0, kLine = 1, kSurface = 2 };

/// Calls of one function of BezierPatch. For kStep and kLine the net is one row.
struct PatchInput {
  PatchFunction function = PatchFunction::kStep;
  std::vector<std::vector<Point3>> net;
  std::vector<std::array<double, 2>> parameters;  ///< (t, unused) or (u, v)

  template <class Wire>
  void transfer(Wire& wire) {
    wire(function, net, parameters);
  }
};

/// The net of the patch whose evaluateStep or evaluate1D gets `points`: of other points than
/// these, so that it shows when a function reads the member in place of its argument. It has as
/// many rows as columns, since a function may count on that where all nets are 4 x 4.
inline std::vector<std::vector<Point3>> net_besides(std::vector<Point3> points) {
  for (Point3& p : points)
    p = {p[0] + 1.0, p[1] + 2.0, p[2] + 3.0};
  return std::vector<std::vector<Point3>>(points.size(), points);
}

}  // namespace meshgrade
