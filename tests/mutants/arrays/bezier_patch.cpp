#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  // SOLUTION BEGIN BezierPatch::evaluateStep
  std::vector<Vector3D> level = points;
  for (std::size_t i = 0; i + 1 < level.size(); i++) {
    level[i] = (1 - t) * points[i] + t * points[i + 1];
  }
  level.pop_back();
  return level;
  // SOLUTION END
}

Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  // SOLUTION BEGIN BezierPatch::evaluate1D
  std::vector<std::vector<Vector3D>> levels = {points};
  while (levels.back().size() > 1) {
    levels.push_back(evaluateStep(levels.back(), t));
  }
  return levels.back()[0];
  // SOLUTION END
}

Vector3D BezierPatch::evaluate(double u, double v) const {
  // SOLUTION BEGIN BezierPatch::evaluate
  std::vector<Vector3D> column;
  for (std::size_t i = 0; i < controlPoints.size(); i++) {
    std::vector<Vector3D> row = controlPoints[i];
    column.push_back(evaluate1D(row, u));
  }
  return evaluate1D(column, v);
  // SOLUTION END
}

}  // namespace meshedit
