// Wrong: a static variable keeps the t of the first call.
#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  static const double s = t;
  std::vector<Vector2D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - s) * points[i] + s * points[i + 1]);
  }
  return next;
}

}  // namespace meshedit
