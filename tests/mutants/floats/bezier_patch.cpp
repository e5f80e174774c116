#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

float mix(double a, double b, float t) {
  return (1 - t) * static_cast<float>(a) + t * static_cast<float>(b);
}

}  // namespace
// SOLUTION END

// Computes in float.
std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  // SOLUTION BEGIN BezierPatch::evaluateStep
  std::vector<Vector3D> next;
  float s = static_cast<float>(t);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    Vector3D p = points[i];
    Vector3D q = points[i + 1];
    next.push_back(Vector3D(mix(p.x, q.x, s), mix(p.y, q.y, s), mix(p.z, q.z, s)));
  }
  return next;
  // SOLUTION END
}

Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  // SOLUTION BEGIN BezierPatch::evaluate1D
  std::vector<Vector3D> level = points;
  for (std::size_t left = points.size(); left > 1; --left) {
    level = evaluateStep(level, t);
  }
  return level.front();
  // SOLUTION END
}

Vector3D BezierPatch::evaluate(double u, double v) const {
  // SOLUTION BEGIN BezierPatch::evaluate
  std::vector<Vector3D> column;
  for (std::size_t row = 0; row < controlPoints.size(); ++row) {
    column.push_back(evaluate1D(controlPoints[row], u));
  }
  return evaluate1D(column, v);
  // SOLUTION END
}

}  // namespace meshedit
