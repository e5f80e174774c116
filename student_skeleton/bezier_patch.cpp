#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE bezier_patch, part 1: one level of de Casteljau's algorithm, now in space and with
// the parameter t as an argument. From n points (n is at least 2) to n - 1 points.
std::vector<Vector3D> BezierPatch::evaluateStep(const std::vector<Vector3D>& points,
                                                double t) const {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("BezierPatch::evaluateStep");
}

// EXERCISE bezier_patch, part 2: the point at t of the curve with these control points. There
// is at least one of them, and there can be any number.
Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& points, double t) const {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("BezierPatch::evaluate1D");
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
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("BezierPatch::evaluate");
}

}  // namespace meshedit
