#include <algorithm>

#include "grader/cases/bezier_input.h"
#include "grader/worker/exercises.h"
#include "grader/worker/stub.h"
#include "meshedit/bezier.h"

namespace meshgrade {
namespace {

/// A curve whose control points and parameter can be set and looked at from outside.
class OpenCurve : public meshedit::BezierCurve {
 public:
  OpenCurve(const std::vector<meshedit::Vector2D>& points, double parameter)
      : BezierCurve(static_cast<int>(points.size())) {
    controlPoints = points;
    t = static_cast<float>(parameter);
  }

  bool has_members_of(const OpenCurve& other) const {
    const auto same = [](const meshedit::Vector2D& a, const meshedit::Vector2D& b) {
      return a.x == b.x && a.y == b.y;
    };
    return t == other.t && numControlPoints == other.numControlPoints &&
           std::equal(controlPoints.begin(), controlPoints.end(), other.controlPoints.begin(),
                      other.controlPoints.end(), same);
  }
};

std::vector<Point2> to_plane_points(const std::vector<meshedit::Vector2D>& vectors) {
  std::vector<Point2> points;
  for (const meshedit::Vector2D& v : vectors)
    points.push_back({v.x, v.y});
  return points;
}

}  // namespace

void run_bezier_curve(WireReader& input, Recorder& recorder) {
  const CurveInput asked = input.read<CurveInput>();
  std::vector<meshedit::Vector2D> points;
  for (const Point2& p : asked.points)
    points.emplace_back(p[0], p[1]);
  OpenCurve curve(points, asked.t);
  const OpenCurve before = curve;
  for (std::uint32_t i = 0; i < asked.steps && points.size() >= 2; ++i) {
    const std::vector<meshedit::Vector2D> result = curve.evaluateStep(points);
    const std::uint32_t kept = curve.has_members_of(before) ? 1 : 0;
    recorder.add_step(CurveStep{to_plane_points(result), to_plane_points(points), kept});
    points = result;
  }
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::vector<Vector2D> BezierCurve::evaluateStep(
    const std::vector<Vector2D>& /*points*/) {
  notImplemented("BezierCurve::evaluateStep");
}

}  // namespace meshedit
