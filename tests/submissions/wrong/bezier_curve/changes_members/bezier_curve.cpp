#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE bezier_curve: one level of de Casteljau's algorithm.
//
//          p[1] ----o---- p[2]          Four points make three segments. On each segment
//          /                 |          lies one point of the next level (o), the part t of
//         o                  o          the way from its start to its end: at t = 0 the
//        /                   |          start, at t = 1 the end.
//     p[0]                 p[3]
//
// You get the n points of one level (n is at least 2) and return the n - 1 points of the next,
// in the same order. `t` is a member of the class. Take one step only: whoever calls this
// function calls it again with what you returned, until one point is left.
std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {
  // SOLUTION BEGIN BezierCurve::evaluateStep
  const double s = t;  // t is a float; all arithmetic is done in double
  std::vector<Vector2D> next;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    next.push_back((1.0 - s) * points[i] + s * points[i + 1]);
  }
  controlPoints = next;      // keeps the last level in the class
  --numControlPoints;
  return next;
  // SOLUTION END
}

}  // namespace meshedit
