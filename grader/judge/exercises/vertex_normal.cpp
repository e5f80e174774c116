#include <cmath>

#include "grader/base/text.h"
#include "grader/cases/mesh_input.h"
#include "grader/judge/findings.h"
#include "grader/judge/judge.h"
#include "grader/judge/normals.h"
#include "grader/judge/options.h"
#include "grader/judge/point_compare.h"

namespace meshgrade {
namespace {

void judge_steps(const JudgeTask& task, Conventions& /*conventions*/,
                 CaseJudgement& judgement) {
  const auto input = from_wire<NormalInput>(task.asked.input);
  const std::vector<Point3> expected = vertex_normals(input.mesh, NormalWeight::kArea);
  if (task.outcome.steps.size() > expected.size()) throw WireError("too many steps");
  std::vector<Point3> actual;
  for (const std::string& step : task.outcome.steps)
    actual.push_back(from_wire<Point3>(step));
  const WorstPoint worst = worst_point(expected, actual);
  if (worst.error <= task.tolerance) {
    require_all_steps(task.outcome, expected.size());
    return;
  }
  judgement.verdict = Verdict::kFailed;
  const Point3& normal = actual[worst.index];
  const double norm = std::hypot(normal[0], normal[1], normal[2]);
  const std::string vertex = vertex_name(static_cast<Ref>(worst.index));
  const std::string expected_text = point_text(expected[worst.index]);
  if (!std::isfinite(norm)) {
    const auto loops = boundary_loops(input.mesh);
    const bool on_boundary = loops.count(static_cast<std::uint32_t>(worst.index)) != 0;
    judgement.findings.push_back(make_finding(
        "finite", "every coordinate is a finite number", "", vertex, expected_text,
        point_text(normal),
        std::string("a division by zero: has what is normalized the length 0?") +
            (on_boundary ? " This vertex lies on the boundary: is any of its faces added up?"
                         : "")));
  } else if (std::abs(norm - 1.0) > task.tolerance) {
    judgement.findings.push_back(make_finding(
        "unit-length", "a normal has length 1", "", vertex, expected_text,
        point_text(normal) + ", of length " + number_text(norm), "the end of Vertex::normal"));
  } else {
    judgement.findings.push_back(make_finding(
        "value", "the mean of the normals of the faces around, weighted by their areas", "",
        vertex, expected_text,
        point_text(normal) + ", off by " + number_text(worst.error, 2) +
            " (allowed: " + number_text(task.tolerance, 2) + ")",
        "which faces are counted in Vertex::normal, and with which weights"));
  }
  judgement.findings.back().likely =
      recognize_normals(input.mesh, expected, actual, task.tolerance);
  mention_anchoring(input.anchoring, judgement);
}

}  // namespace

ExerciseJudge vertex_normal_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  return {{"Vertex::normal"}, {}, judge_steps, normal_misconceptions()};
}

}  // namespace meshgrade
