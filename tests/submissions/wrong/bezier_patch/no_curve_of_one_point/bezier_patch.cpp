#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE bezier_patch, part 1: one level of de Casteljau's algorithm, now in space and with
// the parameter t as an argument. From n points (n is at least 2) to n - 1 points.
std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  // SOLUTION BEGIN BezierPatch::evaluateStep
  std::vector<Vector3D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - t) * points[i] + t * points[i + 1]);
  }
  return next;
  // SOLUTION END
}

// EXERCISE bezier_patch, part 2: the point at t of the curve with these control points. There
// is at least one of them, and there can be any number.
Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  // SOLUTION BEGIN BezierPatch::evaluate1D
  std::vector<Vector3D> level = points;
  do {
    level = evaluateStep(level, t);
  } while (level.size() > 1);
  return level.empty() ? Vector3D() : level.front();
  // SOLUTION END
}

// EXERCISE bezier_patch, part 3: the point of the surface at (u, v).
//
//                            u -->
//     controlPoints[0]     o    o    o    o   ---  a curve; at u it has the point q[0]
//     controlPoints[1]     o    o    o    o   ---                                q[1]
//     controlPoints[2]     o    o    o    o   ---                                q[2]
//
// Each row is a curve: take its point at u. The points that you get, one for each row, are the
// control points of one more curve: its point at v is the answer. The net can have any number
// of rows and of columns.
Vector3D BezierPatch::evaluate(double u, double v) const {
  // SOLUTION BEGIN BezierPatch::evaluate
  std::vector<Vector3D> column;
  for (const std::vector<Vector3D>& row : controlPoints) {
    column.push_back(evaluate1D(row, u));
  }
  return evaluate1D(column, v);
  // SOLUTION END
}

}  // namespace meshedit
