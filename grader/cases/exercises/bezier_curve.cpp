#include "grader/base/text.h"
#include "grader/cases/bezier_input.h"
#include "grader/cases/bezier_shapes.h"
#include "grader/cases/bezier_skeleton.h"
#include "grader/cases/case_list.h"

namespace meshgrade {
namespace {

std::vector<Point2> random_points(std::size_t count, Random& random) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({random.between(-5.0, 5.0), random.between(-5.0, 5.0)});
  }
  return points;
}

void add_curve_step(CaseMaker& maker, const std::string& group, std::vector<Point2> points,
                    double t) {
  const std::string title =
      "one step with " + plural(points.size(), "point") + " at t = " + number_text(t);
  maker.add(group, title, kNoSteps, CurveInput{std::move(points), t, 1});
}

void add_whole(CaseMaker& maker, const std::string& what, std::vector<Point2> points,
               double t) {
  const auto steps = static_cast<std::uint32_t>(points.size() - 1);
  maker.add("whole",
            "all " + std::to_string(steps) + " steps on " + what + " at t = " + number_text(t),
            kNoSteps, CurveInput{std::move(points), t, steps});
}

/// A grid of parameters, and what must not depend on the size, the place and the direction.
void add_moved_curves(CaseMaker& maker, std::size_t count) {
  Random random = maker.random("moved");
  for (double t : kParameterGrid)
    add_curve_step(maker, "stress", points_on_grid<Point2>(count, random), t);
  const auto points = points_on_grid<Point2>(4, random);
  const double t = kParameterGrid[random.below(2)];
  for (const auto& moved : moved_points(points)) {
    maker.add("stress", "all 3 steps with 4 points, " + moved.how, kNoSteps,
              CurveInput{moved.points, t, 3});
  }
  // So that the middle of two points, the first of the next level, is the origin.
  auto around = points;
  around[1] = {-around[0][0], -around[0][1]};
  add_curve_step(maker, "stress", around, 0.5);
}

/// What a curve of many points keeps from call to call shows in a process of its own.
void add_fresh_curve(CaseMaker& maker) {
  Random random = maker.random("fresh");
  maker.add_fresh("stress", "all 8 steps with 9 points, before anything else", kNoSteps,
                  CurveInput{points_on_grid<Point2>(9, random), 0.375, 8});
}

void make_cases_of_any_size(CaseMaker& maker, Random& random) {
  for (std::size_t count : {2U, 3U, 4U, 6U}) {
    for (double t : {0.5, 0.25, 0.0, 1.0}) {
      add_curve_step(maker, "basic", random_points(count, random), t);
    }
  }
  for (const char* file : {"parabola_3.bzc", "arch_4.bzc", "loop_6.bzc", "wave_10.bzc"}) {
    for (double t : {0.25, 0.5, 0.0, 1.0, random.unit()}) {
      add_whole(maker, file, maker.curve(file), t);
    }
  }
  for (std::size_t count = 2; count <= 20; ++count) {
    add_curve_step(maker, "stress", random_points(count, random), random.unit());
  }
  add_curve_step(maker, "stress", random_points(30, random), random.unit());
  add_moved_curves(maker, 5);
  add_fresh_curve(maker);
}

/// Berkeley's curves have 4 points: a step is made from 4 points, and since 2020, where it is
/// given its points, from the 3 and 2 of the levels behind.
void make_cases_of_four_points(CaseMaker& maker, bool on_levels, Random& random) {
  const std::vector<std::size_t> counts =
      on_levels ? std::vector<std::size_t>{4} : std::vector<std::size_t>{2, 3, 4};
  for (std::size_t count : counts) {
    for (double t : {0.5, 0.25, 0.0, 1.0}) {
      add_curve_step(maker, "basic", random_points(count, random), t);
    }
  }
  for (int curve = 0; curve < 4; ++curve) {
    const auto points = curve == 0 ? maker.curve("arch_4.bzc") : random_points(4, random);
    for (double t : {0.25, 0.5, 0.0, 1.0, random.unit()}) {
      add_whole(maker, curve == 0 ? "arch_4.bzc" : "a random curve", points, t);
    }
  }
  for (std::size_t i = 0; i < 20; ++i) {
    add_curve_step(maker, "stress", random_points(counts[i % counts.size()], random),
                   random.unit());
  }
  add_moved_curves(maker, 4);
}

}  // namespace

void make_bezier_curve_cases(CaseMaker& maker) {
  Random random = maker.random("points");
  const BezierSkeleton skeleton = bezier_skeleton(maker.rubric());
  if (skeleton == BezierSkeleton::kMeshedit) {
    make_cases_of_any_size(maker, random);
  } else {
    make_cases_of_four_points(maker, skeleton == BezierSkeleton::kCourse2017, random);
  }
}

void shrink_bezier_curve_case(CaseMaker& maker, const Case& failed) {
  if (bezier_skeleton(maker.rubric()) == BezierSkeleton::kCourse2017) return;
  const auto input = from_wire<CurveInput>(failed.input);
  if (input.steps != 1) return;
  for (std::size_t count = 2; count < input.points.size(); ++count) {
    const auto end = input.points.begin() + static_cast<std::ptrdiff_t>(count);
    add_curve_step(maker, failed.group, {input.points.begin(), end}, input.t);
  }
}

}  // namespace meshgrade
