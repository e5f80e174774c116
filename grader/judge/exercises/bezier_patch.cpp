#include <cmath>

#include "grader/base/text.h"
#include "grader/cases/bezier_input.h"
#include "grader/cases/bezier_skeleton.h"
#include "grader/judge/bezier_forms.h"
#include "grader/judge/findings.h"
#include "grader/judge/judge.h"
#include "grader/judge/local_scale.h"
#include "grader/judge/options.h"
#include "grader/judge/point_compare.h"

namespace meshgrade {
namespace {

const char* function_name(PatchFunction function) {
  switch (function) {
    case PatchFunction::kStep:
      return "evaluateStep";
    case PatchFunction::kLine:
      return "evaluate1D";
    case PatchFunction::kSurface:
      return "evaluate";
  }
  return "";
}

const char* patch_formula(PatchFunction function) {
  switch (function) {
    case PatchFunction::kStep:
      return "point i of the result is (1 - t) points[i] + t points[i + 1]";
    case PatchFunction::kLine:
      return "the result is the point at t of the curve with these control points";
    case PatchFunction::kSurface:
      return "each row at u, then the curve of the results at v";
  }
  return "";
}

/// The surface point as a sum of products of Bernstein polynomials.
Point3 tensor_bernstein(const std::vector<std::vector<Point3>>& net, double u, double v) {
  std::vector<Point3> column;
  for (const auto& row : net)
    column.push_back(bernstein(row, u));
  return bernstein(column, v);
}

std::vector<Point3> expected_result(const PatchInput& input, double u, double v) {
  switch (input.function) {
    case PatchFunction::kStep:
      return de_casteljau_step(input.net[0], u);
    case PatchFunction::kLine:
      return {bernstein(input.net[0], u)};
    case PatchFunction::kSurface:
      return {tensor_bernstein(input.net, u, v)};
  }
  return {};
}

using Predictions = std::vector<Prediction<Point3>>;

const Misconceptions& patch_misconceptions() {
  static const Misconceptions known{
      {"t-swapped", "t and 1 - t are swapped"},
      {"t-truncated",
       "t has become a whole number: 0. Or is this simply the first control point?"},
      {"whole-curve", "this is the point of the whole curve; evaluateStep makes one level"},
      {"whole-curve-t-swapped",
       "this is the point of the whole curve, and with t and 1 - t swapped; evaluateStep makes "
       "one level"},
      {"member-read",
       "the result comes from the member controlPoints: this function works on its argument "
       "`points`"},
      {"two-steps", "the step was applied twice"},
      {"first-level", "this is the first point after one level: repeat until one is left"},
      {"last-of-first-level",
       "this is the last point after one level: repeat until one is left"},
      {"last-point", "this is the last control point"},
      {"uv-swapped", "u and v are swapped: rows are evaluated at u, their results at v"},
      {"u-twice", "u is used in both directions"},
      {"v-twice", "v is used in both directions"},
      {"first-row", "this is a point of the first row only"},
      {"last-row", "this is a point of the last row only"},
      {"not-computed", "this is (0, 0, 0): was it computed?"},
  };
  return known;
}

Predictions predict_step(const std::vector<Point3>& row, double t) {
  return {{"t-swapped", de_casteljau_step(row, 1.0 - t)},
          {"t-truncated", de_casteljau_step(row, std::trunc(t))},
          {"whole-curve", {bernstein(row, t)}},
          {"whole-curve-t-swapped", {bernstein(row, 1.0 - t)}},
          {"member-read", de_casteljau_step(net_besides(row)[0], t)},
          {"two-steps", de_casteljau_step(de_casteljau_step(row, t), t)},
          {"not-computed", std::vector<Point3>(row.size() - 1)}};
}

Predictions predict_line(const std::vector<Point3>& row, double t) {
  if (row.size() < 2) return {{"not-computed", {Point3{}}}};
  const std::vector<Point3> level = de_casteljau_step(row, t);
  return {{"t-swapped", {bernstein(row, 1.0 - t)}},
          {"t-truncated", {bernstein(row, std::trunc(t))}},
          {"first-level", {level.front()}},
          {"last-of-first-level", {level.back()}},
          {"last-point", {row.back()}},
          {"member-read", {bernstein(net_besides(row)[0], t)}},
          {"not-computed", {Point3{}}}};
}

Predictions predict_surface(const std::vector<std::vector<Point3>>& net, double u, double v) {
  return {{"uv-swapped", {tensor_bernstein(net, v, u)}},
          {"t-swapped", {tensor_bernstein(net, 1.0 - u, 1.0 - v)}},
          {"t-truncated", {tensor_bernstein(net, std::trunc(u), std::trunc(v))}},
          {"u-twice", {tensor_bernstein(net, u, u)}},
          {"v-twice", {tensor_bernstein(net, v, v)}},
          {"first-row", {bernstein(net.front(), u)}},
          {"last-row", {bernstein(net.back(), u)}},
          {"last-point", {net.back().back()}},
          {"not-computed", {Point3{}}}};
}

/// Nothing at the ends of a curve, where too many mistakes give the same control points.
Predictions predict_patch(const PatchInput& input, double u, double v) {
  if (u == 0.0 || u == 1.0) return {};
  switch (input.function) {
    case PatchFunction::kStep:
      return predict_step(input.net[0], u);
    case PatchFunction::kLine:
      return predict_line(input.net[0], u);
    case PatchFunction::kSurface:
      return predict_surface(input.net, u, v);
  }
  return {};
}

std::string place_text(const PatchInput& input, std::array<double, 2> place) {
  if (input.function != PatchFunction::kSurface) return "t = " + number_text(place[0]);
  return "u = " + number_text(place[0]) + ", v = " + number_text(place[1]);
}

/// A single point has no extent: its numbers are rounded by how far it is from the origin.
LocalScale scale_of(const PatchInput& input, double tolerance) {
  std::vector<Point3> all;
  for (const auto& row : input.net)
    all.insert(all.end(), row.begin(), row.end());
  if (all.size() == 1) all.push_back({0.0, 0.0, 0.0});
  const double size = extent(all);
  return {size, tolerance * size + float_rounding(largest_coordinate(all)), "the size"};
}

void judge_result(const JudgeTask& task, const PatchInput& input, std::size_t index,
                  CaseJudgement& judgement) {
  const auto place = input.parameters[index];
  const auto actual = from_wire<std::vector<Point3>>(task.outcome.steps[index]);
  const std::vector<Point3> expected = expected_result(input, place[0], place[1]);
  const std::string where = "at " + place_text(input, place);
  const std::string name = function_name(input.function);
  const LocalScale scale = scale_of(input, task.tolerance);
  const auto likely = [&] {
    return recognize(patch_misconceptions(), predict_patch(input, place[0], place[1]), actual,
                     scale.allowed);
  };
  judgement.verdict = Verdict::kFailed;
  if (actual.size() != expected.size()) {
    judgement.findings.push_back(
        make_finding("count", "one step makes n - 1 points out of n", where, "the result",
                     plural(expected.size(), "point"), plural(actual.size(), "point"),
                     "the bounds of the loop and the list that is returned, in " + name));
    judgement.findings.back().likely = likely();
    return;
  }
  const WorstPoint worst = worst_point(expected, actual);
  if (worst.error <= scale.allowed) {
    judgement.verdict = Verdict::kPassed;
    return;
  }
  judgement.findings.push_back(make_finding(
      "value", patch_formula(input.function), where,
      input.function == PatchFunction::kStep ? "point " + std::to_string(worst.index)
                                             : "the result",
      point_text(expected[worst.index]),
      point_text(actual[worst.index]) + ", off by " + error_text(worst.error, scale),
      "BezierPatch::" + name));
  judgement.findings.back().likely = likely();
}

void judge_patch_results(const JudgeTask& task, Conventions& /*conventions*/,
                         CaseJudgement& judgement) {
  const auto input = from_wire<PatchInput>(task.asked.input);
  if (task.outcome.steps.size() > input.parameters.size()) throw WireError("too many steps");
  for (std::size_t i = 0; i < task.outcome.steps.size(); ++i) {
    judge_result(task, input, i, judgement);
    if (!judgement.findings.empty()) return;
  }
  require_all_steps(task.outcome, input.parameters.size());
}

std::string called_by(const Case& asked) {
  return std::string("BezierPatch::") +
         function_name(from_wire<PatchInput>(asked.input).function);
}

}  // namespace

ExerciseJudge bezier_patch_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {kSkeletonOption});
  choose_option(rubric, kSkeletonOption, skeleton_choices());
  std::vector<std::string> functions{"BezierPatch::evaluate1D", "BezierPatch::evaluate"};
  if (bezier_skeleton(rubric) != BezierSkeleton::kCourse2017) {
    functions.insert(functions.begin(), "BezierPatch::evaluateStep");
  }
  return {functions, {},       judge_patch_results, patch_misconceptions(), nullptr, false,
          {},        called_by};
}

}  // namespace meshgrade
