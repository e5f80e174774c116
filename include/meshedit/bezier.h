#pragma once

// Bezier curves and patches by de Casteljau's algorithm. You write the `evaluate...` functions.

#include <cstddef>
#include <utility>
#include <vector>

#include "detail/added.h"
#include "vector2d.h"
#include "vector3d.h"

// Members of a homework's own: see halfedge_mesh.h.
#ifdef MESHEDIT_ADDED
#include "halfedge_mesh.h"
#endif

namespace meshedit {

/// A Bezier curve of the plane with any number of control points.
class BezierCurve : public detail::Added<BezierCurve> {
 public:
  explicit BezierCurve(int n)
      : controlPoints(static_cast<std::size_t>(n)), t(0.0F), numControlPoints(n) {}

  /// EXERCISE bezier_curve. One level of de Casteljau's algorithm.
  ///
  /// @param points  the n points of one level, n >= 2. They stay as they are, and so do the
  ///                members of the curve.
  /// @return the n - 1 points of the next level: (1 - t) points[i] + t points[i + 1], in order,
  ///         with `t` the member of this class. Not the whole curve: whoever calls this
  ///         function repeats it until one point is left.
  MESHEDIT_YOURS std::vector<Vector2D> evaluateStep(const std::vector<Vector2D>& points);

 protected:
  std::vector<Vector2D> controlPoints;
  float t;  ///< the parameter, from 0 to 1
  int numControlPoints;

#ifdef MESHEDIT_ADDED
 public:
#include "meshedit_added_curve.h"
#endif
};

/// A Bezier surface over a net of control points: rows of equal length, at least one of each.
class BezierPatch : public detail::Added<BezierPatch> {
 public:
  BezierPatch() = default;
  explicit BezierPatch(std::vector<std::vector<Vector3D>> net)
      : controlPoints(std::move(net)) {}

  /// EXERCISE bezier_patch, part 1. One level of de Casteljau's algorithm in space.
  ///
  /// @param points  the n points of one level, n >= 2
  /// @param t       the parameter, from 0 to 1
  /// @return the n - 1 points of the next level: (1 - t) points[i] + t points[i + 1].
  MESHEDIT_YOURS std::vector<Vector3D> evaluateStep(const std::vector<Vector3D>& points,
                                                    double t) const;

  /// EXERCISE bezier_patch, part 2. The point at t of the curve with these control points.
  ///
  /// @param points  the n control points of a curve, n >= 1
  MESHEDIT_YOURS Vector3D evaluate1D(const std::vector<Vector3D>& points, double t) const;

  /// EXERCISE bezier_patch, part 3. The point of the surface at (u, v).
  ///
  /// Each row `controlPoints[i]` is a curve and is evaluated at u. The results, one for each
  /// row and in the order of the rows, are the control points of one more curve, which is
  /// evaluated at v. The net need not be square and need not be 4 x 4.
  MESHEDIT_YOURS Vector3D evaluate(double u, double v) const;

 protected:
  std::vector<std::vector<Vector3D>> controlPoints;

#ifdef MESHEDIT_ADDED
 public:
#include "meshedit_added_patch.h"
#endif
};

}  // namespace meshedit
