// Wrong: the function belongs to no class.
#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector2D> evaluateStep(const std::vector<Vector2D>& points) {
  const double s = 0.5;
  std::vector<Vector2D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - s) * points[i] + s * points[i + 1]);
  }
  return next;
}

}  // namespace meshedit
