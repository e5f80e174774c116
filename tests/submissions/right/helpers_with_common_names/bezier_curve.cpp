// Right: helpers of its own in the global namespace, with names that many choose.
#include "meshedit/meshedit.h"

using namespace std;
using namespace meshedit;

Vector2D lerp(const Vector2D& a, const Vector2D& b, double t) {
  return (1 - t) * a + t * b;
}

vector<Vector2D> BezierCurve::evaluateStep(vector<Vector2D> const& points) {
  vector<Vector2D> average;
  for (size_t i = 1; i < points.size(); i++)
    average.push_back(lerp(points[i - 1], points[i], t));
  return average;
}
