// Right: computes in float.
#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  std::vector<Vector2D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1 - t) * points[i] + t * points[i + 1]);
  }
  return next;
}

}  // namespace meshedit
