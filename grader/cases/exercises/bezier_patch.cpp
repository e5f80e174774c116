#include <algorithm>

#include "grader/base/text.h"
#include "grader/cases/bezier_input.h"
#include "grader/cases/bezier_shapes.h"
#include "grader/cases/bezier_skeleton.h"
#include "grader/cases/case_list.h"

namespace meshgrade {
namespace {

using Net = std::vector<std::vector<Point3>>;

/// A place (u, v) that is another one with u and v swapped, with 1 - u and 1 - v, with u twice
/// and with v twice: so that the answer tells these mistakes apart.
constexpr std::array<double, 2> kPlace{0.25, 0.625};

const std::vector<std::string> kStepCalls{"BezierPatch::evaluateStep"};
const std::vector<std::string> kLineCalls{"BezierPatch::evaluate1D",
                                          "BezierPatch::evaluateStep"};
const std::vector<std::string> kSurfaceCalls{"BezierPatch::evaluate", "BezierPatch::evaluate1D",
                                             "BezierPatch::evaluateStep"};

std::vector<Point3> random_row(std::size_t count, Random& random) {
  std::vector<Point3> row;
  for (std::size_t i = 0; i < count; ++i) {
    row.push_back(
        {random.between(-3.0, 3.0), random.between(-3.0, 3.0), random.between(-3.0, 3.0)});
  }
  return row;
}

Net random_net(std::size_t rows, std::size_t columns, Random& random) {
  Net net;
  for (std::size_t i = 0; i < rows; ++i)
    net.push_back(random_row(columns, random));
  return net;
}

Net to_net(const ControlNet& control) {
  Net net(control.rows);
  for (std::size_t r = 0; r < control.rows; ++r) {
    for (std::size_t c = 0; c < control.cols; ++c)
      net[r].push_back(control.at(r, c));
  }
  return net;
}

/// The first rows and columns of a net.
Net corner_of(const Net& net, std::size_t rows, std::size_t columns) {
  Net corner(net.begin(), net.begin() + static_cast<std::ptrdiff_t>(rows));
  for (std::vector<Point3>& row : corner)
    row.resize(columns);
  return corner;
}

std::string place_text(std::size_t count, double t) {
  return plural(count, "point") + " at t = " + number_text(t);
}

void add_patch_step(CaseMaker& maker, std::size_t count, double t, Random& random) {
  maker.add("step", "evaluateStep on " + place_text(count, t), kNoSteps,
            PatchInput{PatchFunction::kStep, {random_row(count, random)}, {{t, 0.0}}},
            kStepCalls);
}

void add_line(CaseMaker& maker, const std::string& group, std::size_t count, double t,
              Random& random) {
  maker.add(group, "evaluate1D on " + place_text(count, t), kNoSteps,
            PatchInput{PatchFunction::kLine, {random_row(count, random)}, {{t, 0.0}}},
            kLineCalls);
}

void add_surface(CaseMaker& maker, const std::string& group, const std::string& what, Net net,
                 const std::vector<std::array<double, 2>>& parameters) {
  const std::string title = "evaluate on " + what + " (" + plural(net.size(), "row") + " of " +
                            std::to_string(net[0].size()) + ") at " +
                            plural(parameters.size(), "place");
  maker.add(group, title, kNoSteps,
            PatchInput{PatchFunction::kSurface, std::move(net), parameters}, kSurfaceCalls);
}

/// The steps that a curve is made of, each a question of its own: who gets one of them wrong
/// has to look at evaluateStep, not at evaluate1D.
void add_steps_of(CaseMaker& maker, const std::string& group, std::vector<Point3> level,
                  double t) {
  while (level.size() > 1) {
    maker.add(group,
              "evaluateStep on " + place_text(level.size(), t) + ", as evaluate1D calls it",
              kNoSteps, PatchInput{PatchFunction::kStep, {level}, {{t, 0.0}}}, kStepCalls);
    for (std::size_t i = 0; i + 1 < level.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        level[i][axis] = (1.0 - t) * level[i][axis] + t * level[i + 1][axis];
    }
    level.pop_back();
  }
}

/// The curves along u that a point of the surface is made of, as questions of their own.
void add_lines_of(CaseMaker& maker, const std::string& group, const Net& net, double u) {
  for (const std::vector<Point3>& row : net) {
    maker.add(group, "evaluate1D on " + place_text(row.size(), u) + ", as evaluate calls it",
              kNoSteps, PatchInput{PatchFunction::kLine, {row}, {{u, 0.0}}}, kLineCalls);
  }
}

/// More numbers of points, and the grid of parameters in a process of its own.
void add_rows(CaseMaker& maker) {
  Random random = maker.random("rows");
  for (std::size_t count : {5U, 6U, 8U, 16U, 24U}) {
    add_patch_step(maker, count, random.unit(), random);
    add_line(maker, "line", count, random.unit(), random);
  }
  std::vector<std::array<double, 2>> grid;
  for (double t : kParameterGrid)
    grid.push_back({t, 0.0});
  const std::string places = " with 5 points at " + plural(grid.size(), "place");
  maker.add_fresh("step", "evaluateStep" + places + ", before anything else", kNoSteps,
                  PatchInput{PatchFunction::kStep, {random_row(5, random)}, grid}, kStepCalls);
  maker.add_fresh("line", "evaluate1D" + places + ", before anything else", kNoSteps,
                  PatchInput{PatchFunction::kLine, {random_row(5, random)}, grid}, kLineCalls);
}

/// All sizes from 2 to 8, and some beyond.
void add_sizes(CaseMaker& maker) {
  Random random = maker.random("sizes");
  std::vector<std::pair<std::size_t, std::size_t>> sizes{{3, 13}, {13, 3}, {2, 24}, {24, 2}};
  for (std::size_t rows = 2; rows <= 8; ++rows) {
    for (std::size_t columns = 2; columns <= 8; ++columns)
      sizes.emplace_back(rows, columns);
  }
  for (const auto& [rows, columns] : sizes) {
    add_surface(maker, "stress", "a random net", random_net(rows, columns, random),
                {kPlace, {random.unit(), random.unit()}});
  }
}

/// What must not depend on the size, the place and the direction, and a grid of parameters.
void add_moved_nets(CaseMaker& maker) {
  Random random = maker.random("moved");
  constexpr std::size_t kRows = 4;
  constexpr std::size_t kColumns = 4;
  const auto points = points_on_grid<Point3>(kRows * kColumns, random);
  for (const auto& moved : moved_points(points)) {
    Net net;
    for (std::size_t r = 0; r < kRows; ++r) {
      const auto row = moved.points.begin() + static_cast<std::ptrdiff_t>(r * kColumns);
      net.emplace_back(row, row + kColumns);
    }
    add_surface(maker, "stress", "a random net " + moved.how, net, {kPlace, {0.875, 0.75}});
  }
  // Each value of the grid once for u and once for v, with none of them at the same place.
  std::vector<std::array<double, 2>> places{kPlace};
  for (std::size_t i = 0; i < kParameterGrid.size(); ++i)
    places.push_back({kParameterGrid[i], kParameterGrid[(i + 4) % kParameterGrid.size()]});
  maker.add_fresh("stress",
                  "evaluate on a random net (4 rows of 4) at a grid of places, "
                  "before anything else",
                  kNoSteps,
                  PatchInput{PatchFunction::kSurface, random_net(4, 4, random), places},
                  kSurfaceCalls);
}

void make_lines_of_any_size(CaseMaker& maker, Random& random, Random& more) {
  for (std::size_t count : {2U, 3U, 4U, 7U}) {
    for (double t : {0.5, 0.25, 0.0, 1.0, random.unit()}) {
      add_patch_step(maker, count, t, random);
      add_line(maker, "line", count, t, random);
    }
  }
  add_patch_step(maker, 12, more.unit(), more);
  add_line(maker, "line", 12, more.unit(), more);
  add_line(maker, "line", 1, more.unit(), more);  // a curve of one point is that point
}

/// Lines of 4 points, as Berkeley's patches have them. Where there is no evaluateStep, the
/// points for a step are given for what takes its place.
void make_lines_of_four_points(CaseMaker& maker, bool has_step, Random& random) {
  for (std::size_t count : {2U, 3U, 4U, 4U}) {
    for (double t : {0.5, 0.25, 0.0, 1.0, random.unit()}) {
      if (has_step) {
        add_patch_step(maker, count, t, random);
      } else {
        add_line(maker, "step", 4, t, random);
      }
      add_line(maker, "line", 4, t, random);
    }
  }
}

void add_surfaces(CaseMaker& maker, Random& random) {
  add_surface(maker, "surface", "wavy.bez", to_net(maker.patches("wavy.bez").at(0)),
              {kPlace, {0.5, 0.5}, {0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}});
  for (int i = 0; i < 6; ++i) {
    add_surface(maker, "surface", "a random net", random_net(4, 4, random),
                {kPlace, {random.unit(), random.unit()}, {1.0, 0.0}});
  }
}

void add_nets_of_many_sizes(CaseMaker& maker, Random& random) {
  add_surface(maker, "stress", "net_3x5.bez", to_net(maker.patches("net_3x5.bez").at(0)),
              {kPlace, {0.0, 1.0}, {random.unit(), random.unit()}});
  for (std::size_t rows : {2U, 3U, 5U}) {
    for (std::size_t columns : {2U, 4U, 6U}) {
      add_surface(maker, "stress", "a random net", random_net(rows, columns, random),
                  {kPlace, {random.unit(), random.unit()}});
    }
  }
}

void add_teapot(CaseMaker& maker, Random& random) {
  int number = 0;
  for (const ControlNet& patch : maker.patches("teapot.bez")) {
    add_surface(maker, "stress", "patch " + std::to_string(++number) + " of the teapot",
                to_net(patch), {{random.unit(), random.unit()}, {0.5, 0.25}});
  }
}

}  // namespace

void make_bezier_patch_cases(CaseMaker& maker) {
  Random random = maker.random("nets");
  Random more = maker.random("other sizes");
  const BezierSkeleton skeleton = bezier_skeleton(maker.rubric());
  if (skeleton != BezierSkeleton::kMeshedit) {
    make_lines_of_four_points(maker, skeleton == BezierSkeleton::kCourse2020, random);
    add_surfaces(maker, random);
    add_teapot(maker, random);
    return add_moved_nets(maker);
  }
  make_lines_of_any_size(maker, random, more);
  add_surfaces(maker, random);
  add_nets_of_many_sizes(maker, random);
  add_teapot(maker, random);
  for (const auto& [rows, columns] :
       {std::pair(1U, 4U), std::pair(4U, 1U), std::pair(1U, 1U)}) {
    add_surface(maker, "stress", "a random net", random_net(rows, columns, more), {kPlace});
  }
  add_rows(maker);
  add_sizes(maker);
  add_moved_nets(maker);
}

void shrink_bezier_patch_case(CaseMaker& maker, const Case& failed) {
  const auto input = from_wire<PatchInput>(failed.input);
  if (input.function == PatchFunction::kLine) {
    return add_steps_of(maker, failed.group, input.net.at(0), input.parameters.at(0)[0]);
  }
  if (input.function != PatchFunction::kSurface) return;
  for (const auto& [u, v] : input.parameters)
    add_lines_of(maker, failed.group, input.net, u);
  const std::size_t rows = input.net.size();
  const std::size_t columns = input.net[0].size();
  const bool any_size = bezier_skeleton(maker.rubric()) == BezierSkeleton::kMeshedit;
  const std::size_t least = any_size ? 2 : 4;
  for (std::size_t r = std::min(rows, least); r <= rows; ++r) {
    for (std::size_t c = std::min(columns, least); c <= columns; ++c) {
      for (const auto& place : input.parameters) {
        if (r == rows && c == columns && input.parameters.size() == 1) continue;
        add_surface(maker, failed.group, "a corner of that net", corner_of(input.net, r, c),
                    {place});
      }
    }
  }
}

}  // namespace meshgrade
