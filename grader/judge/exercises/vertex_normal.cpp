#include <cmath>

#include "grader/base/text.h"
#include "grader/cases/mesh_input.h"
#include "grader/judge/findings.h"
#include "grader/judge/judge.h"
#include "grader/judge/local_scale.h"
#include "grader/judge/normals.h"
#include "grader/judge/options.h"
#include "grader/judge/point_compare.h"

namespace meshgrade {
namespace {

bool points_like(const Point3& unit, const Point3& normal, double norm, double tolerance) {
  return distance(unit, {normal[0] / norm, normal[1] / norm, normal[2] / norm}) <= tolerance;
}

/// What is wrong with a normal: it is no number, it is too long, or it points elsewhere.
Finding wrong_normal(const JudgeTask& task, const NormalInput& input, const WorstPoint& worst,
                     const Point3& expected, const Point3& normal) {
  const double norm = std::hypot(normal[0], normal[1], normal[2]);
  const std::string vertex = vertex_name(static_cast<Ref>(worst.index));
  if (!std::isfinite(norm)) {
    const auto loops = boundary_loops(input.mesh);
    const bool on_boundary = loops.count(static_cast<std::uint32_t>(worst.index)) != 0;
    return make_finding(
        "finite", "every coordinate is a finite number", "", vertex, point_text(expected),
        point_text(normal),
        std::string("a division by zero: has what is normalized the length 0?") +
            (on_boundary ? " This vertex lies on the boundary: is any of its faces added up?"
                         : ""));
  }
  if (std::abs(norm - 1.0) > task.tolerance) {
    return make_finding(
        "unit-length", "a normal has length 1", "", vertex, point_text(expected),
        point_text(normal) + ", of length " + number_text(norm),
        norm == 0.0 ? "is anything added to the sum in Vertex::normal?"
        : points_like(expected, normal, norm, task.tolerance)
            ? "the end of Vertex::normal"
            : "its direction, too, is wrong: first which faces are counted in Vertex::normal, "
              "and with which weights");
  }
  return make_finding("value",
                      "the mean of the normals of the faces around, weighted by their areas",
                      "", vertex, point_text(expected),
                      point_text(normal) + ", off by " + number_text(worst.error, 2) +
                          " (allowed: " + number_text(task.tolerance, 2) + ")",
                      "which faces are counted in Vertex::normal, and with which weights");
}

void judge_normals(const JudgeTask& task, Conventions& /*conventions*/,
                   CaseJudgement& judgement) {
  const auto input = from_wire<NormalInput>(task.asked.input);
  const std::vector<Point3> expected = vertex_normals(input.mesh, NormalWeight::kArea);
  if (task.outcome.steps.size() > expected.size()) throw WireError("too many steps");
  std::vector<Point3> actual;
  for (const std::string& step : task.outcome.steps)
    actual.push_back(from_wire<Point3>(step));
  const std::vector<LocalScale> scales = scales_of_normals(input.mesh, task.tolerance);
  if (are_within(expected, actual, scales)) {
    require_all_steps(task.outcome, expected.size());
    return;
  }
  judgement.verdict = Verdict::kFailed;
  const WorstPoint worst = worst_by_scale(expected, actual, scales);
  judgement.findings.push_back(
      wrong_normal(task, input, worst, expected[worst.index], actual[worst.index]));
  judgement.findings.back().likely =
      recognize_normals(input.mesh, expected, actual, task.tolerance);
  mention_anchoring(input.anchoring, judgement);
}

}  // namespace

ExerciseJudge vertex_normal_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  return {{"Vertex::normal"}, {}, judge_normals, normal_misconceptions()};
}

}  // namespace meshgrade
