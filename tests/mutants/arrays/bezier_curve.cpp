#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  // SOLUTION BEGIN BezierCurve::evaluateStep
  std::vector<Vector2D> level = points;
  for (std::size_t i = 0; i + 1 < level.size(); i++) {
    level[i] = level[i] + t * (level[i + 1] - level[i]);
  }
  level.pop_back();
  return level;
  // SOLUTION END
}

}  // namespace meshedit
