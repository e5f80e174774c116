#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  // SOLUTION BEGIN BezierCurve::evaluateStep
  std::vector<Vector2D> next(points.size() - 1);
  for (std::size_t i = 1; i < points.size(); i++) {
    next[i - 1] = points[i - 1] * (1 - t) + points[i] * t;
  }
  return next;
  // SOLUTION END
}

}  // namespace meshedit
