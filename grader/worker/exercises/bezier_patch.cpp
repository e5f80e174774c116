#include "grader/cases/bezier_input.h"
#include "grader/worker/exercises.h"
#include "grader/worker/stub.h"
#include "meshedit/bezier.h"

namespace meshgrade {
namespace {

std::vector<meshedit::Vector3D> to_vectors(const std::vector<Point3>& points) {
  std::vector<meshedit::Vector3D> vectors;
  for (const Point3& p : points)
    vectors.emplace_back(p[0], p[1], p[2]);
  return vectors;
}

std::vector<std::vector<meshedit::Vector3D>> to_net(
    const std::vector<std::vector<Point3>>& rows) {
  std::vector<std::vector<meshedit::Vector3D>> net;
  for (const auto& row : rows)
    net.push_back(to_vectors(row));
  return net;
}

std::vector<Point3> to_space_points(const std::vector<meshedit::Vector3D>& vectors) {
  std::vector<Point3> points;
  for (const meshedit::Vector3D& v : vectors)
    points.push_back({v.x, v.y, v.z});
  return points;
}

}  // namespace

void run_bezier_patch(WireReader& input, Recorder& recorder) {
  const PatchInput asked = input.read<PatchInput>();
  const bool whole = asked.function == PatchFunction::kSurface;
  const meshedit::BezierPatch patch(to_net(whole ? asked.net : net_besides(asked.net.at(0))));
  const std::vector<meshedit::Vector3D> points = to_vectors(asked.net.at(0));
  for (const auto& [u, v] : asked.parameters) {
    switch (asked.function) {
      case PatchFunction::kStep:
        recorder.add_step(to_space_points(patch.evaluateStep(points, u)));
        break;
      case PatchFunction::kLine:
        recorder.add_step(to_space_points({patch.evaluate1D(points, u)}));
        break;
      case PatchFunction::kSurface:
        recorder.add_step(to_space_points({patch.evaluate(u, v)}));
        break;
    }
  }
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::vector<Vector3D> BezierPatch::evaluateStep(
    const std::vector<Vector3D>& /*points*/, double /*t*/) const {
  notImplemented("BezierPatch::evaluateStep");
}

MESHGRADE_STUB Vector3D BezierPatch::evaluate1D(const std::vector<Vector3D>& /*points*/,
                                                double /*t*/) const {
  notImplemented("BezierPatch::evaluate1D");
}

MESHGRADE_STUB Vector3D BezierPatch::evaluate(double /*u*/, double /*v*/) const {
  notImplemented("BezierPatch::evaluate");
}

}  // namespace meshedit
