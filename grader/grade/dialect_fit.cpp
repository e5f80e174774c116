#include "grader/grade/dialect_fit.h"

#include <algorithm>
#include <map>
#include <set>

#include "grader/base/contains.h"
#include "grader/cases/bezier_skeleton.h"
#include "grader/operations/course_rules.h"
#include "grader/operations/local_operation_list.h"
#include "grader/submission/function_extents.h"
#include "grader/submission/scotty3d_files.h"

namespace meshgrade {
namespace {

std::string skeleton_of(Dialect dialect) {
  switch (dialect) {
    case Dialect::kMeshedit:
    case Dialect::kScotty3d:
    case Dialect::kScotty3d2020:
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

void name_as_in_scotty3d(Assignment& assignment, Dialect dialect) {
  assignment.tolerance = std::max(assignment.tolerance, kFloatTolerance);
  for (ExerciseRubric& rubric : assignment.exercises) {
    rubric.other_names.clear();  // an assignment may be fitted twice
    for (const Scotty3dFunction& function : scotty3d_functions(dialect))
      rubric.other_names.emplace_back(function.our_name, function.their_name);
  }
}

/// Leaves only these exercises.
template <class IsAsked>
void keep_exercises(Assignment& assignment, IsAsked is_asked) {
  auto& exercises = assignment.exercises;
  exercises.erase(
      std::remove_if(exercises.begin(), exercises.end(),
                     [&](const ExerciseRubric& rubric) { return !is_asked(rubric); }),
      exercises.end());
  for (ExerciseRubric& rubric : exercises) {
    rubric.needs.erase(std::remove_if(rubric.needs.begin(), rubric.needs.end(),
                                      [&](const std::string& name) {
                                        return assignment.find(name) == nullptr;
                                      }),
                       rubric.needs.end());
  }
}

void leave_out_groups(ExerciseRubric& rubric, const std::vector<std::string>& names) {
  auto& groups = rubric.groups;
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                              [&](const Group& group) { return contains(names, group.name); }),
               groups.end());
}

/// Until Spring 2022. What is left out here, their own program did not ask of the functions: it
/// calls them for meshes without boundary, and Loop subdivision for triangles only.
Assignment fit_to_scotty3d_2020(Assignment assignment) {
  static const std::map<std::string, std::vector<std::string>> not_asked{
      {"catmull_clark", {"boundary"}}, {"loop_refinement", {"boundary", "refused"}}};
  std::set<std::string> known;
  for (const Scotty3dFunction& function : scotty3d_functions(Dialect::kScotty3d2020))
    known.insert(function.exercise);
  keep_exercises(assignment,
                 [&](const ExerciseRubric& rubric) { return known.count(rubric.name) != 0; });
  for (ExerciseRubric& rubric : assignment.exercises) {
    const auto groups = not_asked.find(rubric.name);
    if (groups != not_asked.end()) leave_out_groups(rubric, groups->second);
    if (find_local_operation(rubric.name) != nullptr)
      rubric.options[kRulesOption] = {rules_choices().at(1), rubric.place};
  }
  return assignment;
}

bool defines(const Submission& submission, const std::string& name) {
  return std::any_of(
      submission.sources.begin(), submission.sources.end(), [&](const SourceFile& source) {
        const std::vector<FunctionExtent> functions = find_functions(source.text);
        return std::any_of(functions.begin(), functions.end(),
                           [&](const FunctionExtent& f) { return f.name == name; });
      });
}

}  // namespace

Assignment fit_to_dialect(Assignment assignment, Dialect dialect) {
  if (is_scotty3d(dialect)) name_as_in_scotty3d(assignment, dialect);
  if (dialect == Dialect::kScotty3d2020) return fit_to_scotty3d_2020(std::move(assignment));
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

Assignment fit_to_submission(Assignment assignment, const Submission& submission) {
  return fit_to_class(std::move(assignment), {submission});
}

Assignment fit_to_class(Assignment assignment, const std::vector<Submission>& submissions) {
  if (submissions.empty()) return assignment;
  const Dialect dialect = submissions[0].dialect;
  const bool is_one_dialect =
      std::all_of(submissions.begin(), submissions.end(),
                  [&](const Submission& other) { return other.dialect == dialect; });
  if (!is_one_dialect) return assignment;
  assignment = fit_to_dialect(std::move(assignment), dialect);
  if (dialect != Dialect::kScotty3d2020) return assignment;
  keep_exercises(assignment, [&](const ExerciseRubric& rubric) {
    const bool is_late = rubric.name == "vertex_inset";  // since Spring 2022
    return !is_late || std::any_of(submissions.begin(), submissions.end(),
                                   [](const Submission& submission) {
                                     return defines(submission, "Halfedge_Mesh::inset_vertex");
                                   });
  });
  return assignment;
}

}  // namespace meshgrade
