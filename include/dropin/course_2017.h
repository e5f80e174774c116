#pragma once

// The Bezier classes of the years 2017 to 2019, where they differ from meshedit's. Included by
// the grader before files of these years; adapter_2017.cpp connects them with meshedit's.

#include <cstddef>
#include <utility>
#include <vector>

#include "course.h"

namespace meshedit {

/// A curve that remembers all levels of de Casteljau's algorithm.
class BezierCurve2017 : public detail::Added<BezierCurve> {
 public:
  explicit BezierCurve2017(int n)
      : controlPoints(static_cast<std::size_t>(n)), t(0.0F), numControlPoints(n) {}

  /// Appends the next level, one point shorter, to `evaluatedLevels`.
  MESHEDIT_YOURS void evaluateStep();

 protected:
  std::vector<Vector2D> controlPoints;
  /// The first level is the control points.
  std::vector<std::vector<Vector2D>> evaluatedLevels;
  float t;
  int numControlPoints;

#ifdef MESHEDIT_ADDED
 public:
#include "meshedit_added_curve_2017.h"
#endif
};

/// A patch without a function for the single step.
class BezierPatch2017 : public detail::Added<BezierPatch> {
 public:
  BezierPatch2017() = default;
  explicit BezierPatch2017(std::vector<std::vector<Vector3D>> net)
      : controlPoints(std::move(net)) {}

  MESHEDIT_YOURS Vector3D evaluate(double u, double v) const;
  MESHEDIT_YOURS Vector3D evaluate1D(std::vector<Vector3D> points, double t) const;

 protected:
  std::vector<std::vector<Vector3D>> controlPoints;

#ifdef MESHEDIT_ADDED
 public:
#include "meshedit_added_patch_2017.h"
#endif
};

}  // namespace meshedit

#define BezierCurve BezierCurve2017
#define BezierPatch BezierPatch2017
