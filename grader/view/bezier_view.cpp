#include "grader/view/bezier_view.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "grader/base/errors.h"
#include "grader/cases/bezier_input.h"
#include "grader/cases/view_input.h"
#include "grader/judge/bezier_forms.h"
#include "grader/report/report_value.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPoints = 40;
constexpr int kCurveSamples = 64;
constexpr int kMostDensity = 64;

template <class Input>
Case case_of(const std::string& exercise, const Input& input) {
  Case asked;
  asked.exercise = exercise;
  asked.group = kViewTask;
  asked.number = 1;
  asked.input = to_wire(input);
  return asked;
}

Json tell(const StudentProgram& program, const Case& asked, const Outcome& outcome) {
  ExerciseRubric rubric;
  rubric.name = asked.exercise;
  const ExerciseRubric* known = program.assignment().find(asked.exercise);
  if (known != nullptr) rubric = *known;
  const ExerciseJudge judge = find_exercise_judge(rubric);
  Conventions conventions = judge.conventions;
  CaseJudgement judgement =
      judge_case(judge, {asked, outcome, rubric, program.assignment().tolerance}, conventions);
  return to_json_value(program.tell(asked.exercise, "", std::move(judgement), outcome));
}

template <class Point>
bool is_finite(const Point& point) {
  return std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
}

template <class Point>
void require_finite(const std::vector<Point>& points) {
  if (!std::all_of(points.begin(), points.end(), is_finite<Point>)) {
    throw UserError("every coordinate must be a finite number");
  }
}

CurveInput curve_input(const std::vector<Point2>& points, double t) {
  return {points, static_cast<double>(static_cast<float>(t)),
          static_cast<std::uint32_t>(points.size() - 1)};
}

Json levels_of(const Outcome& outcome) {
  Json levels = Json::array();
  for (const std::string& step : outcome.steps)
    levels.push_back(from_wire<CurveStep>(step).result);
  return levels;
}

/// The last point of each outcome, null where the code did not come so far.
Json curve_of(const std::vector<Outcome>& outcomes, std::size_t steps) {
  Json curve = Json::array();
  for (const Outcome& outcome : outcomes) {
    Json point;
    if (outcome.steps.size() == steps) {
      const auto last = from_wire<CurveStep>(outcome.steps.back()).result;
      if (last.size() == 1) point = last[0];
    }
    curve.push_back(std::move(point));
  }
  return curve;
}

}  // namespace

Json view_curve(const StudentProgram& program, const Json& request) {
  const auto points = request.at("points").get<std::vector<Point2>>();
  const double t = request.at("t");
  if (points.size() < 2 || points.size() > kMostPoints) {
    throw UserError("a curve has 2 to 40 control points here");
  }
  require_finite(points);
  std::vector<Case> cases{case_of("bezier_curve", curve_input(points, t))};
  Json exact = Json::array();
  for (int i = 0; i <= kCurveSamples; ++i) {
    const CurveInput input = curve_input(points, static_cast<double>(i) / kCurveSamples);
    cases.push_back(case_of("bezier_curve", input));
    exact.push_back(bernstein(points, input.t));
  }
  std::vector<Outcome> outcomes = program.run(cases);
  Json value{{"told", tell(program, cases[0], outcomes[0])},
             {"levels", levels_of(outcomes[0])},
             {"exact", std::move(exact)}};
  outcomes.erase(outcomes.begin());
  value["curve"] = curve_of(outcomes, points.size() - 1);
  return value;
}

Json view_patch(const StudentProgram& program, const Json& request) {
  PatchInput input;
  input.function = PatchFunction::kSurface;
  input.net = request.at("net").get<std::vector<std::vector<Point3>>>();
  const int density = std::clamp(request.at("density").get<int>(), 1, kMostDensity);
  if (input.net.size() < 2 || input.net.size() > kMostPoints) {
    throw UserError("a net has 2 to 40 rows here");
  }
  for (const std::vector<Point3>& row : input.net) {
    if (row.size() != input.net[0].size() || row.size() < 2 || row.size() > kMostPoints) {
      throw UserError("the rows of a net have the same 2 to 40 points each");
    }
    require_finite(row);
  }
  for (int j = 0; j <= density; ++j) {
    for (int i = 0; i <= density; ++i) {
      input.parameters.push_back(
          {static_cast<double>(i) / density, static_cast<double>(j) / density});
    }
  }
  const Case asked = case_of("bezier_patch", input);
  const Outcome outcome = program.run({asked}).at(0);
  Json grid = Json::array();
  for (const std::string& step : outcome.steps) {
    const auto points = from_wire<std::vector<Point3>>(step);
    grid.push_back(points.size() == 1 ? Json(points[0]) : Json(nullptr));
  }
  return {{"told", tell(program, asked, outcome)}, {"grid", std::move(grid)}};
}

}  // namespace meshgrade
