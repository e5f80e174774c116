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
Case bezier_case(const std::string& exercise, const Input& input) {
  Case asked;
  asked.exercise = exercise;
  asked.group = kViewTask;
  asked.number = 1;
  asked.input = to_wire(input);
  return asked;
}

CaseReport tell_bezier(const StudentProgram& program, const Case& asked,
                       const Outcome& outcome) {
  ExerciseRubric rubric;
  rubric.name = asked.exercise;
  const ExerciseRubric* known = program.assignment().find(asked.exercise);
  if (known != nullptr) rubric = *known;
  const ExerciseJudge judge = find_exercise_judge(rubric);
  Conventions conventions = judge.conventions;
  CaseJudgement judgement =
      judge_case(judge, {asked, outcome, rubric, program.assignment().tolerance}, conventions);
  return program.tell(asked.exercise, "", std::move(judgement), outcome);
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

/// The last point of each outcome, if the code came so far.
std::vector<std::optional<Point2>> curve_of(const std::vector<Outcome>& outcomes,
                                            std::size_t steps) {
  std::vector<std::optional<Point2>> curve;
  for (const Outcome& outcome : outcomes) {
    std::optional<Point2>& point = curve.emplace_back();
    if (outcome.steps.size() != steps) continue;
    const auto last = from_wire<CurveStep>(outcome.steps.back()).result;
    if (last.size() == 1) point = last[0];
  }
  return curve;
}

template <class Point>
Json to_json_list(const std::vector<std::optional<Point>>& points) {
  Json list = Json::array();
  for (const auto& point : points)
    list.push_back(point ? Json(*point) : Json(nullptr));
  return list;
}

void require_net(const std::vector<std::vector<Point3>>& net) {
  if (net.size() < 2 || net.size() > kMostPoints) {
    throw UserError("a net has 2 to 40 rows here");
  }
  for (const std::vector<Point3>& row : net) {
    if (row.size() != net[0].size() || row.size() < 2 || row.size() > kMostPoints) {
      throw UserError("the rows of a net have the same 2 to 40 points each");
    }
    require_finite(row);
  }
}

/// The points of a grid over the whole surface, u running fastest.
std::vector<Point2> grid_parameters(int density) {
  std::vector<Point2> parameters;
  for (int j = 0; j <= density; ++j) {
    for (int i = 0; i <= density; ++i) {
      parameters.push_back(
          {static_cast<double>(i) / density, static_cast<double>(j) / density});
    }
  }
  return parameters;
}

/// The control net of a request, with nothing asked of it yet.
PatchInput surface_input(const Json& request) {
  PatchInput input;
  input.function = PatchFunction::kSurface;
  input.net = request.at("net").get<std::vector<std::vector<Point3>>>();
  require_net(input.net);
  return input;
}

/// What evaluate gave from one step to before another, nothing where it gave none.
std::vector<std::optional<Point3>> surface_points(const Outcome& outcome, std::size_t from,
                                                  std::size_t to) {
  std::vector<std::optional<Point3>> list;
  for (std::size_t i = from; i < std::min(to, outcome.steps.size()); ++i) {
    const auto points = from_wire<std::vector<Point3>>(outcome.steps[i]);
    list.push_back(points.size() == 1 ? std::optional<Point3>(points[0]) : std::nullopt);
  }
  return list;
}

}  // namespace

CurveLook look_at_curve(const StudentProgram& program, const std::vector<Point2>& points,
                        double t) {
  if (points.size() < 2 || points.size() > kMostPoints) {
    throw UserError("a curve has 2 to 40 control points here");
  }
  require_finite(points);
  if (!(t >= 0.0 && t <= 1.0)) throw UserError("t goes from 0 to 1");
  CurveLook look;
  look.points = points;
  look.t = t;
  std::vector<Case> cases{bezier_case("bezier_curve", curve_input(points, t))};
  for (int i = 0; i <= kCurveSamples; ++i) {
    const CurveInput input = curve_input(points, static_cast<double>(i) / kCurveSamples);
    cases.push_back(bezier_case("bezier_curve", input));
    look.exact.push_back(bernstein(points, input.t));
  }
  std::vector<Outcome> outcomes = program.run(cases);
  look.told = tell_bezier(program, cases[0], outcomes[0]);
  for (const std::string& step : outcomes[0].steps)
    look.levels.push_back(from_wire<CurveStep>(step).result);
  outcomes.erase(outcomes.begin());
  look.curve = curve_of(outcomes, points.size() - 1);
  return look;
}

PatchLook look_at_patches(const StudentProgram& program, const std::vector<ControlNet>& nets,
                          int density) {
  if (density < 1 || density > kMostDensity) {
    throw UserError("a surface is sampled 1 to 64 times along each side");
  }
  std::vector<Case> cases;
  for (const ControlNet& net : nets) {
    PatchInput input;
    input.function = PatchFunction::kSurface;
    for (std::size_t row = 0; row < net.rows; ++row) {
      input.net.emplace_back();
      for (std::size_t col = 0; col < net.cols; ++col)
        input.net.back().push_back(net.at(row, col));
    }
    require_net(input.net);
    input.parameters = grid_parameters(density);
    cases.push_back(bezier_case("bezier_patch", input));
  }
  const std::vector<Outcome> outcomes = program.run(cases);
  PatchLook look;
  look.density = density;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    look.grids.push_back(surface_points(outcomes[i], 0, outcomes[i].steps.size()));
    if (i == 0 || look.told.verdict == Verdict::kPassed)
      look.told = tell_bezier(program, cases[i], outcomes[i]);
  }
  return look;
}

Json view_curve(const StudentProgram& program, const Json& request) {
  const CurveLook look = look_at_curve(program, request.at("points").get<std::vector<Point2>>(),
                                       request.at("t").get<double>());
  return {{"told", to_json_value(look.told)},
          {"levels", look.levels},
          {"exact", look.exact},
          {"curve", to_json_list(look.curve)}};
}

Json view_patch(const StudentProgram& program, const Json& request) {
  PatchInput input = surface_input(request);
  const auto asked_density = request.at("density").get<double>();
  if (!(asked_density >= 1 && asked_density <= kMostDensity)) {
    throw UserError("a surface is sampled 1 to 64 times along each side");
  }
  input.parameters = grid_parameters(static_cast<int>(asked_density));
  const Case asked = bezier_case("bezier_patch", input);
  const Outcome outcome = program.run({asked}).at(0);
  return {{"told", to_json_value(tell_bezier(program, asked, outcome))},
          {"grid", to_json_list(surface_points(outcome, 0, outcome.steps.size()))}};
}

Json view_isocurves(const StudentProgram& program, const Json& request) {
  PatchInput input = surface_input(request);
  const auto u = request.at("u").get<double>();
  const auto v = request.at("v").get<double>();
  if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1)) throw UserError("u and v go from 0 to 1");
  for (int i = 0; i <= kCurveSamples; ++i)
    input.parameters.push_back({static_cast<double>(i) / kCurveSamples, v});
  for (int i = 0; i <= kCurveSamples; ++i)
    input.parameters.push_back({u, static_cast<double>(i) / kCurveSamples});
  const Case asked = bezier_case("bezier_patch", input);
  const Outcome outcome = program.run({asked}).at(0);
  return {{"along_u", to_json_list(surface_points(outcome, 0, kCurveSamples + 1))},
          {"along_v",
           to_json_list(surface_points(outcome, kCurveSamples + 1, 2 * (kCurveSamples + 1)))}};
}

}  // namespace meshgrade
