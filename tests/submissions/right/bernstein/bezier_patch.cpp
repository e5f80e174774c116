// Right: evaluate1D and evaluate use Bernstein polynomials.
#include "meshedit/meshedit.h"

namespace meshedit {

static double bernstein(int n, int i, double t) {
  double weight = 1.0;
  for (int k = 1; k <= i; ++k)
    weight *= static_cast<double>(n - i + k) / k;
  return weight * std::pow(t, i) * std::pow(1.0 - t, n - i);
}

std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  std::vector<Vector3D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - t) * points[i] + t * points[i + 1]);
  }
  return next;
}

Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  const int n = static_cast<int>(points.size()) - 1;
  Vector3D sum;
  for (int i = 0; i <= n; ++i)
    sum += bernstein(n, i, t) * points[i];
  return sum;
}

Vector3D BezierPatch::evaluate(double u, double v) const {
  const int n = static_cast<int>(controlPoints.size()) - 1;
  const int m = static_cast<int>(controlPoints[0].size()) - 1;
  Vector3D sum;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= m; ++j)
      sum += bernstein(n, i, v) * bernstein(m, j, u) * controlPoints[i][j];
  }
  return sum;
}

}  // namespace meshedit
