// Wrong: takes two steps where one is asked.
#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  const double s = t;  // t is a float; all arithmetic is done in double
  std::vector<Vector2D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - s) * points[i] + s * points[i + 1]);
  }
  if (next.size() < 2) return next;
  std::vector<Vector2D> after_next;
  for (std::size_t i = 0; i + 1 < next.size(); ++i) {
    after_next.push_back((1.0 - s) * next[i] + s * next[i + 1]);
  }
  return after_next;
}

}  // namespace meshedit
