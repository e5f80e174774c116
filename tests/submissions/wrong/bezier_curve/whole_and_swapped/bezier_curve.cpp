// Wrong: all levels at once, and t and 1 - t are swapped.
#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  const double s = t;  // t is a float; all arithmetic is done in double
  std::vector<Vector2D> level = points;
  while (level.size() > 1) {
    std::vector<Vector2D> next;
    for (std::size_t i = 0; i + 1 < level.size(); ++i) {
      next.push_back(s * level[i] + (1.0 - s) * level[i + 1]);
    }
    level = next;
  }
  return level;
}

}  // namespace meshedit
