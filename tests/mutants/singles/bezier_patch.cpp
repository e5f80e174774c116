#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  // SOLUTION BEGIN BezierPatch::evaluateStep
  std::vector<Vector3D> result(points.size() - 1);
  for (std::size_t i = 0; i < result.size(); i++) {
    result[i] = points[i] + t * (points[i + 1] - points[i]);
  }
  return result;
  // SOLUTION END
}

Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  // SOLUTION BEGIN BezierPatch::evaluate1D
  std::vector<Vector3D> level = points;
  for (std::size_t i = 1; i < points.size(); i++) {
    level = evaluateStep(level, t);
  }
  return level[0];
  // SOLUTION END
}

Vector3D BezierPatch::evaluate(double u, double v) const {
  // SOLUTION BEGIN BezierPatch::evaluate
  std::vector<Vector3D> points(controlPoints.size());
  for (std::size_t i = 0; i < controlPoints.size(); i++) {
    points[i] = evaluate1D(controlPoints[i], u);
  }
  return evaluate1D(points, v);
  // SOLUTION END
}

}  // namespace meshedit
