#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  // SOLUTION BEGIN BezierCurve::evaluateStep
  std::vector<Vector2D> result;
  for (int i = 0; i < static_cast<int>(points.size()) - 1; i++) {
    double x = (1 - t) * points[i].x + t * points[i + 1].x;
    double y = (1 - t) * points[i].y + t * points[i + 1].y;
    result.push_back(Vector2D(x, y));
  }
  return result;
  // SOLUTION END
}

}  // namespace meshedit
