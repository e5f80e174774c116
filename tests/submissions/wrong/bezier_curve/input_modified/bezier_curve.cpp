// Wrong: computes in the list that it is given.
#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  const double s = t;  // t is a float; all arithmetic is done in double
  std::vector<Vector2D>& level = const_cast<std::vector<Vector2D>&>(points);
  for (std::size_t i = 0; i + 1 < level.size(); ++i) {
    level[i] = (1.0 - s) * level[i] + s * level[i + 1];
  }
  std::vector<Vector2D> next(level.begin(), level.end() - 1);
  return next;
}

}  // namespace meshedit
