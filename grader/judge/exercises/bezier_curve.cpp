#include <cmath>

#include "grader/base/text.h"
#include "grader/cases/bezier_input.h"
#include "grader/cases/bezier_skeleton.h"
#include "grader/judge/bezier_forms.h"
#include "grader/judge/findings.h"
#include "grader/judge/judge.h"
#include "grader/judge/options.h"
#include "grader/judge/point_compare.h"

namespace meshgrade {
namespace {

const Misconceptions& curve_misconceptions() {
  static const Misconceptions known{
      {"t-swapped", "t and 1 - t are swapped: at t = 0 the result begins at points[i]"},
      {"t-ignored", "the points are always halved: the member t is not used"},
      {"t-truncated",
       "t has become a whole number: 0. Is it kept in an int, or divided as whole numbers?"},
      {"whole-curve",
       "this is the point of the whole curve: evaluateStep makes one level only, and whoever "
       "calls it repeats it"},
      {"whole-curve-t-swapped",
       "this is the point of the whole curve, and with t and 1 - t swapped: evaluateStep makes "
       "one level only, and at t = 0 its result begins at points[i]"},
      {"member-read",
       "the result comes from the member controlPoints: a step works on its argument `points`, "
       "which holds the level before"},
      {"two-steps", "the step was applied twice"},
      {"unchanged", "the points are returned as they came"},
      {"not-computed", "all points are (0, 0): were they computed?"},
  };
  return known;
}

/// What the first step gives to those who misunderstand it.
std::vector<Prediction<Point2>> predict_first(const std::vector<Point2>& given, double t) {
  const std::vector<Point2> halfway = de_casteljau_step(given, t);
  return {{"t-swapped", de_casteljau_step(given, 1.0 - t)},
          {"t-ignored", de_casteljau_step(given, 0.5)},
          {"t-truncated", de_casteljau_step(given, std::trunc(t))},
          {"whole-curve", {bernstein(given, t)}},
          {"whole-curve-t-swapped", {bernstein(given, 1.0 - t)}},
          {"two-steps", de_casteljau_step(halfway, t)},
          {"unchanged", given},
          {"not-computed", std::vector<Point2>(given.size() - 1)}};
}

/// What a later step gives to those who got the first one right: they read what only then is
/// another list than the argument. `whole` is the control polygon, `given` the level before.
std::vector<Prediction<Point2>> predict_later(const std::vector<Point2>& whole,
                                              const std::vector<Point2>& given, double t) {
  const std::vector<Point2> all = de_casteljau_step(whole, t);
  const auto count = static_cast<std::ptrdiff_t>(given.size() - 1);
  return {{"member-read", all}, {"member-read", {all.begin(), all.begin() + count}}};
}

class StepsJudge {
 public:
  StepsJudge(const JudgeTask& task, CurveInput input, CaseJudgement& judgement)
      : task_(task), input_(std::move(input)), judgement_(judgement) {}

  /// @return false at the first step that is wrong
  bool judge_step(std::size_t index, const std::vector<Point2>& given, const CurveStep& step) {
    where_ = input_.steps == 1 ? ""
                               : "in step " + std::to_string(index + 1) + " of " +
                                     std::to_string(input_.steps);
    if (!leaves_input(given, step)) return false;
    if (has_count(given, step) && has_values(given, step)) return true;
    judgement_.findings.back().likely =
        recognize(curve_misconceptions(), predict(index, given), step.result, allowed());
    return false;
  }

  /// The last point against the closed form of the whole curve.
  void judge_curve_point(const CurveStep& last) {
    const Point2 expected = bernstein(input_.points, input_.t);
    const double error = distance(expected, last.result[0]);
    if (error <= allowed()) return;
    report("curve-point", "repeated steps end at the point of the curve (its Bernstein form)",
           "the last point", point_text(expected),
           point_text(last.result[0]) + ", off by " + off_by(error), "evaluateStep");
  }

 private:
  /// Nothing at the ends of the curve, where too many mistakes give the same control points.
  std::vector<Prediction<Point2>> predict(std::size_t index,
                                          const std::vector<Point2>& given) const {
    if (input_.t == 0.0 || input_.t == 1.0) return {};
    return index == 0 ? predict_first(given, input_.t)
                      : predict_later(input_.points, given, input_.t);
  }

  /// How far a point may be off: also what computing in float gives far from the origin.
  double allowed() const {
    return task_.tolerance * extent(input_.points) +
           float_rounding(largest_coordinate(input_.points));
  }

  std::string off_by(double error) const {
    const double size = extent(input_.points);
    return error_text(error, size, allowed() / size);
  }

  void report(std::string rule, std::string meaning, std::string element, std::string expected,
              std::string actual, std::string look_at) {
    judgement_.verdict = Verdict::kFailed;
    judgement_.findings.push_back(make_finding(std::move(rule), std::move(meaning), where_,
                                               std::move(element), std::move(expected),
                                               std::move(actual), std::move(look_at)));
  }

  bool leaves_input(const std::vector<Point2>& given, const CurveStep& step) {
    if (step.input_after != given) {
      report("input", "evaluateStep leaves the points that it is given as they are",
             "the points that were passed in", "unchanged", "changed", "writes to `points`");
      return false;
    }
    if (step.keeps_members == 0) {
      report("input", "evaluateStep leaves the members of the curve as they are",
             "controlPoints, numControlPoints and t of the curve", "unchanged", "changed",
             "writes to these members");
      return false;
    }
    return true;
  }

  bool has_count(const std::vector<Point2>& given, const CurveStep& step) {
    const std::size_t expected = given.size() - 1;
    if (step.result.size() == expected) return true;
    const bool whole = step.result.size() == 1 && given.size() > 2;
    report("count", "one step makes n - 1 points out of n", "the result",
           plural(expected, "point") + " from " + plural(given.size(), "point"),
           plural(step.result.size(), "point"),
           whole ? "evaluateStep makes one level only; whoever calls it repeats it"
                 : "the bounds of the loop and the list that is returned");
    return false;
  }

  bool has_values(const std::vector<Point2>& given, const CurveStep& step) {
    const std::vector<Point2> expected = de_casteljau_step(given, input_.t);
    const WorstPoint worst = worst_point(expected, step.result);
    if (worst.error <= allowed()) return true;
    const std::string i = std::to_string(worst.index);
    report(
        "value", "point i of the result is (1 - t) points[i] + t points[i + 1]", "point " + i,
        point_text(expected[worst.index]) + " = (1 - t) " + point_text(given[worst.index]) +
            " + t " + point_text(given[worst.index + 1]) + " with t = " + number_text(input_.t),
        point_text(step.result[worst.index]) + ", off by " + off_by(worst.error),
        "the formula for point " + i);
    return false;
  }

  const JudgeTask& task_;
  CurveInput input_;
  CaseJudgement& judgement_;
  std::string where_;
};

void judge_curve_steps(const JudgeTask& task, Conventions& /*conventions*/,
                       CaseJudgement& judgement) {
  const auto input = from_wire<CurveInput>(task.asked.input);
  if (task.outcome.steps.size() > input.steps) throw WireError("too many steps");
  StepsJudge judge(task, input, judgement);
  std::vector<Point2> given = input.points;
  CurveStep step;
  for (std::size_t i = 0; i < task.outcome.steps.size(); ++i) {
    step = from_wire<CurveStep>(task.outcome.steps[i]);
    if (!judge.judge_step(i, given, step)) return;
    given = step.result;
  }
  require_all_steps(task.outcome, input.steps);
  if (given.size() == 1 && input.points.size() > 1) judge.judge_curve_point(step);
}

}  // namespace

ExerciseJudge bezier_curve_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {kSkeletonOption});
  choose_option(rubric, kSkeletonOption, skeleton_choices());
  return {{"BezierCurve::evaluateStep"}, {}, judge_curve_steps, curve_misconceptions()};
}

}  // namespace meshgrade
