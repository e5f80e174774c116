// Wrong: keeps at most twenty points.
#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  std::vector<Vector3D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - t) * points[i] + t * points[i + 1]);
  }
  return next;
}

Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  std::vector<Vector3D> level = points;
  if (level.size() > 20) level.resize(20);
  while (level.size() > 1) {
    level = evaluateStep(level, t);
  }
  return level.front();
}

Vector3D BezierPatch::evaluate(double u, double v) const {
  std::vector<Vector3D> column;
  for (const std::vector<Vector3D>& row : controlPoints) {
    column.push_back(evaluate1D(row, u));
  }
  return evaluate1D(column, v);
}

}  // namespace meshedit
