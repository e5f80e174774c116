#include "grader/grade/dialect_fit.h"

#include <algorithm>

#include "grader/cases/bezier_skeleton.h"
#include "grader/submission/scotty3d_files.h"

namespace meshgrade {
namespace {

std::string skeleton_of(Dialect dialect) {
  switch (dialect) {
    case Dialect::kMeshedit:
    case Dialect::kScotty3d:
      return {};
    case Dialect::kCourse2017:
      return skeleton_choices().at(1);
    case Dialect::kCourse2016:
    case Dialect::kCourse2020:
      break;
  }
  return skeleton_choices().at(2);
}

/// What the report calls a group must not be a function that the year does not have.
void rename_step(ExerciseRubric& rubric) {
  const std::string step = "evaluateStep";
  for (Group& group : rubric.groups) {
    const std::size_t at = group.title.find(step);
    if (at != std::string::npos) group.title.replace(at, step.size(), "evaluate1D");
  }
}

/// Of numbers that were computed in float.
constexpr double kFloatTolerance = 1e-4;

Assignment fit_to_scotty3d(Assignment assignment) {
  assignment.tolerance = std::max(assignment.tolerance, kFloatTolerance);
  for (ExerciseRubric& rubric : assignment.exercises) {
    rubric.other_names.clear();  // an assignment may be fitted twice
    for (const Scotty3dFunction& function : scotty3d_functions())
      rubric.other_names.emplace_back(function.our_name, function.their_name);
  }
  return assignment;
}

}  // namespace

Assignment fit_to_dialect(Assignment assignment, Dialect dialect) {
  if (dialect == Dialect::kScotty3d) return fit_to_scotty3d(std::move(assignment));
  const std::string skeleton = skeleton_of(dialect);
  if (skeleton.empty()) return assignment;
  for (ExerciseRubric& rubric : assignment.exercises) {
    const bool is_patch = rubric.name == "bezier_patch";
    if (!is_patch && rubric.name != "bezier_curve") continue;
    rubric.options[kSkeletonOption] = {skeleton, rubric.place};
    if (is_patch && dialect == Dialect::kCourse2017) rename_step(rubric);
  }
  return assignment;
}

}  // namespace meshgrade
