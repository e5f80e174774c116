// Wrong: the step works on the control points, whatever level it gets.
#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  const double s = t;  // t is a float; all arithmetic is done in double
  std::vector<Vector2D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - s) * controlPoints[i] + s * controlPoints[i + 1]);
  }
  return next;
}

}  // namespace meshedit
