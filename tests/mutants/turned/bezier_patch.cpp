#include "meshedit/meshedit.h"

namespace meshedit {

std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  // SOLUTION BEGIN BezierPatch::evaluateStep
  std::vector<Vector3D> next;
  next.reserve(points.size());
  auto p = points.begin();
  for (auto q = p + 1; q != points.end(); ++p, ++q) {
    next.push_back(*p * (1 - t) + *q * t);
  }
  return next;
  // SOLUTION END
}

Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  // SOLUTION BEGIN BezierPatch::evaluate1D
  if (points.size() == 1) return points[0];
  return evaluate1D(evaluateStep(points, t), t);
  // SOLUTION END
}

Vector3D BezierPatch::evaluate(double u, double v) const {
  // SOLUTION BEGIN BezierPatch::evaluate
  std::vector<Vector3D> points;
  for (const auto& row : controlPoints) {
    Vector3D p = evaluate1D(row, u);
    points.push_back(p);
  }
  return evaluate1D(points, v);
  // SOLUTION END
}

}  // namespace meshedit
