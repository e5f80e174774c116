// Lets the grader call the Bezier functions of the years 2017 to 2019. Compiled with each
// submission of these years.

#include "course_2017.h"

#undef BezierCurve
#undef BezierPatch

namespace meshedit {

// Replaced by the student's own definitions when the worker is linked.
[[gnu::weak]] void BezierCurve2017::evaluateStep() {
  notImplemented("BezierCurve::evaluateStep");
}

[[gnu::weak]] Vector3D BezierPatch2017::evaluate(double /*u*/, double /*v*/) const {
  notImplemented("BezierPatch::evaluate");
}

[[gnu::weak]] Vector3D BezierPatch2017::evaluate1D(std::vector<Vector3D> /*points*/,
                                                   double /*t*/) const {
  notImplemented("BezierPatch::evaluate1D");
}

namespace {

/// A curve on its way from its control points to these points: the student's function is given
/// all levels before them, which it has made itself.
class CurveOnLevels : public BezierCurve2017 {
 public:
  CurveOnLevels(const std::vector<Vector2D>& control, float parameter)
      : BezierCurve2017(static_cast<int>(control.size())) {
    controlPoints = control;
    evaluatedLevels = {control};
    t = parameter;
  }

  /// @return false if the student's levels do not get there
  bool step_to(const std::vector<Vector2D>& points) {
    while (last_level().size() > points.size()) {
      const std::size_t before = last_level().size();
      evaluateStep();
      if (last_level().size() + 1 != before) return false;
    }
    return same(last_level(), points);
  }

  std::vector<Vector2D> last_level() const {
    return evaluatedLevels.empty() ? std::vector<Vector2D>() : evaluatedLevels.back();
  }

 private:
  static bool same(const std::vector<Vector2D>& a, const std::vector<Vector2D>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i].x != b[i].x || a[i].y != b[i].y) return false;
    }
    return true;
  }
};

}  // namespace

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  CurveOnLevels curve(controlPoints, t);
  if (!curve.step_to(points)) curve = CurveOnLevels(points, t);
  curve.evaluateStep();
  return curve.last_level();
}

// These years have no such function, and the grader asks for none.
std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& /*points*/,
                                                double /*t*/) const {
  notImplemented("BezierPatch::evaluate1D");
}

Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  return BezierPatch2017(controlPoints).evaluate1D(points, t);
}

Vector3D BezierPatch::evaluate(double u, double v) const {
  return BezierPatch2017(controlPoints).evaluate(u, v);
}

}  // namespace meshedit
