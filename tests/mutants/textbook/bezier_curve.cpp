#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  // SOLUTION BEGIN BezierCurve::evaluateStep
  const std::size_t n = points.size() - 1;
  std::vector<Vector2D> next(n);
  for (std::size_t i = 0; i < n; i++) {
    const double s = t;
    const double x = (1 - s) * points[i].x + s * points[i + 1].x;
    const double y = (1 - s) * points[i].y + s * points[i + 1].y;
    next[i] = Vector2D(x, y);
  }
  return next;
  // SOLUTION END
}

}  // namespace meshedit
