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

class OneStep : public BezierCurve2017 {
 public:
  OneStep(const std::vector<Vector2D>& points, float parameter)
      : BezierCurve2017(static_cast<int>(points.size())) {
    controlPoints = points;
    evaluatedLevels = {points};
    t = parameter;
  }

  std::vector<Vector2D> last_level() const {
    return evaluatedLevels.empty() ? std::vector<Vector2D>() : evaluatedLevels.back();
  }
};

}  // namespace

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  OneStep curve(points, t);
  curve.evaluateStep();
  return curve.last_level();
}

// These years have no such function. A step is, for each pair of neighbours, the line between
// them at t: the student's evaluate1D knows it.
std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  const BezierPatch2017 patch(controlPoints);
  std::vector<Vector3D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back(patch.evaluate1D({points[i], points[i + 1]}, t));
  }
  return next;
}

Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  return BezierPatch2017(controlPoints).evaluate1D(points, t);
}

Vector3D BezierPatch::evaluate(double u, double v) const {
  return BezierPatch2017(controlPoints).evaluate(u, v);
}

}  // namespace meshedit
