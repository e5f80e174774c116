#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  // SOLUTION BEGIN BezierPatch::evaluateStep
  std::vector<Vector3D> next;
  for (std::size_t i = 1; i < points.size(); i++) {
    const Vector3D left = points[i - 1];
    const Vector3D right = points[i];
    next.push_back(left * (1 - t) + right * t);
  }
  return next;
  // SOLUTION END
}

Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  // SOLUTION BEGIN BezierPatch::evaluate1D
  if (points.size() == 1) return points[0];
  const std::vector<Vector3D> level = evaluateStep(points, t);
  return evaluate1D(level, t);
  // SOLUTION END
}

Vector3D BezierPatch::evaluate(double u, double v) const {
  // SOLUTION BEGIN BezierPatch::evaluate
  std::vector<Vector3D> column(controlPoints.size());
  for (std::size_t i = 0; i < controlPoints.size(); i++) {
    const std::vector<Vector3D>& row = controlPoints[i];
    column[i] = evaluate1D(row, u);
  }
  return evaluate1D(column, v);
  // SOLUTION END
}

}  // namespace meshedit
