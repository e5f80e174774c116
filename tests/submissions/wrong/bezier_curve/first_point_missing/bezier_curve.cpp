// Wrong: begins at the second segment.
#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  const double s = t;  // t is a float; all arithmetic is done in double
  std::vector<Vector2D> next;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - s) * points[i] + s * points[i + 1]);
  }
  return next;
}

}  // namespace meshedit
