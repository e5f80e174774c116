#include "meshedit/meshedit.h"

namespace meshedit {

// Computes in float.
std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  // SOLUTION BEGIN BezierCurve::evaluateStep
  std::vector<Vector2D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    float x =
        (1 - t) * static_cast<float>(points[i].x) + t * static_cast<float>(points[i + 1].x);
    float y =
        (1 - t) * static_cast<float>(points[i].y) + t * static_cast<float>(points[i + 1].y);
    next.push_back(Vector2D(x, y));
  }
  return next;
  // SOLUTION END
}

}  // namespace meshedit
