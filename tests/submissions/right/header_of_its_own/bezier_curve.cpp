// Right: a header of its own comes along.
#include "helpers.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  std::vector<Vector2D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back(helpers::lerp(points[i], points[i + 1], t));
  }
  return next;
}

}  // namespace meshedit
