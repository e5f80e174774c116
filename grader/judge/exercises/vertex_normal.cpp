#include <array>
#include <cmath>

#include "grader/base/text.h"
#include "grader/cases/mesh_input.h"
#include "grader/judge/findings.h"
#include "grader/judge/judge.h"
#include "grader/judge/options.h"
#include "grader/judge/point_compare.h"

namespace meshgrade {
namespace {

Point3 subtract(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double length(const Point3& a) {
  return std::hypot(a[0], a[1], a[2]);
}

/// The normals by their definition, without half-edges: every triangle adds its cross product,
/// whose length is twice its area, to its three corners.
std::vector<Point3> area_weighted_normals(const PolygonMesh& mesh) {
  std::vector<Point3> sums(mesh.positions.size(), Point3{});
  for (const auto& t : mesh.polygons) {
    const Point3& p = mesh.positions[t[0]];
    const Point3 area =
        cross(subtract(mesh.positions[t[1]], p), subtract(mesh.positions[t[2]], p));
    for (std::uint32_t corner : t) {
      for (std::size_t i = 0; i < 3; ++i)
        sums[corner][i] += area[i];
    }
  }
  for (Point3& sum : sums) {
    const double norm = length(sum);
    for (double& x : sum)
      x /= norm;
  }
  return sums;
}

void judge_steps(const JudgeTask& task, Conventions& /*conventions*/,
                 CaseJudgement& judgement) {
  const auto input = from_wire<NormalInput>(task.asked.input);
  const std::vector<Point3> expected = area_weighted_normals(input.mesh);
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
  const double norm = length(normal);
  const std::string vertex = vertex_name(static_cast<Ref>(worst.index));
  const std::string expected_text = point_text(expected[worst.index]);
  if (!std::isfinite(norm)) {
    judgement.findings.push_back(make_finding(
        "finite", "every coordinate is a finite number", "", vertex, expected_text,
        point_text(normal), "a division by zero: the length of what is normalized?"));
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
}

}  // namespace

ExerciseJudge vertex_normal_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  return {{"Vertex::normal"}, {}, judge_steps};
}

}  // namespace meshgrade
