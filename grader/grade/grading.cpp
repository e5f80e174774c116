#include "grader/grade/grading.h"

#include <algorithm>
#include <mutex>
#include <numeric>

#include "grader/base/errors.h"
#include "grader/base/parallel.h"
#include "grader/base/text.h"
#include "grader/grade/compile_blame.h"
#include "grader/grade/dialect_fit.h"
#include "grader/grade/exercise_run.h"
#include "grader/grade/right_callees.h"
#include "grader/grade/second_run.h"
#include "grader/judge/judge.h"
#include "grader/run/run.h"

namespace meshgrade {
namespace {

/// The exercises that `rubric` needs, judged. Those that were not asked for are judged on the
/// quiet.
std::vector<JudgedExercise> judge_needed(const Assignment& assignment, const Home& home,
                                         const Candidate& candidate,
                                         const ExerciseRubric& rubric,
                                         const std::vector<ExerciseRun>& asked) {
  std::vector<JudgedExercise> needed;
  for (const std::string& name : rubric.needs) {
    const auto known = std::find_if(asked.begin(), asked.end(), [&](const ExerciseRun& run) {
      return run.judged.rubric->name == name;
    });
    needed.push_back(
        known != asked.end()
            ? known->judged
            : run_exercise(assignment, home, candidate, *assignment.find(name)).judged);
  }
  return needed;
}

/// Gives an exercise that fails its second run, if it needs others that fail.
void run_again(const Assignment& assignment, const Home& home, const Candidate& candidate,
               const std::vector<ExerciseRun>& asked, ExerciseRun& run) {
  const ExerciseRubric& rubric = *run.judged.rubric;
  if (rubric.needs.empty() || is_all_right(run.judged)) return;
  const StageTimer timer(home.times.get(), "run with right solutions");
  run_with_stand_ins(assignment, home, candidate,
                     judge_needed(assignment, home, candidate, rubric, asked), run);
}

/// Exercises that need others work on the largest meshes: begun last, they would be waited for
/// while the other cores have nothing left to do.
std::vector<std::size_t> longest_first(const std::vector<const ExerciseRubric*>& exercises) {
  std::vector<std::size_t> order(exercises.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return exercises[a]->needs.size() > exercises[b]->needs.size();
  });
  return order;
}

ExerciseRun run_case(const Assignment& assignment, const Home& home, const Candidate& candidate,
                     const Case& asked) {
  const ExerciseRubric& rubric = *assignment.find(asked.exercise);
  ExerciseRun run;
  run.cases = {asked};
  run.outcomes = run_cases(candidate.build, {&asked}, assignment.limits, Company::kAlone);
  run.judged = judge_exercise(assignment, home, candidate, rubric, run.cases, run.outcomes);
  return run;
}

}  // namespace

std::vector<const ExerciseRubric*> choose_exercises(const Assignment& assignment,
                                                    const std::vector<std::string>& names) {
  std::vector<const ExerciseRubric*> chosen;
  std::vector<std::string> known;
  for (const ExerciseRubric& rubric : assignment.exercises) {
    known.push_back(rubric.name);
    const bool wanted = std::find(names.begin(), names.end(), rubric.name) != names.end();
    if (names.empty() || wanted) chosen.push_back(&rubric);
  }
  for (const std::string& name : names) {
    if (assignment.find(name) == nullptr) {
      throw UserError("\"" + name + "\" is no exercise of this assignment; there are " +
                      join(known, ", "));
    }
  }
  return chosen;
}

Report grade(const Assignment& given, const Submission& submission, const Home& home,
             const std::vector<std::string>& exercises, const Progress& progress) {
  const Assignment assignment = fit_to_submission(given, submission);
  const std::vector<const ExerciseRubric*> chosen = choose_exercises(assignment, exercises);
  progress("compiling " + plural(submission.sources.size(), "file"));
  const Build build = build_submission(submission, home, assignment.limits);
  const Candidate candidate{submission, build};
  std::vector<ExerciseRun> runs(chosen.size());
  const std::vector<std::size_t> order = longest_first(chosen);
  std::mutex telling;
  in_parallel(cores_of(home), chosen.size(), [&](std::size_t turn) {
    const std::size_t i = order[turn];
    {
      const std::lock_guard lock(telling);
      progress(chosen[i]->name);
    }
    runs[i] = run_exercise(assignment, home, candidate, *chosen[i]);
  });
  for (ExerciseRun& run : runs)
    run_again(assignment, home, candidate, runs, run);
  std::vector<JudgedExercise> judged;
  for (ExerciseRun& run : runs)
    judged.push_back(std::move(run.judged));
  return make_report(assignment, submission, build, judged);
}

Report grade_case(const Assignment& given, const Submission& submission, const Home& home,
                  const Build& build, const Case& asked) {
  const Assignment assignment = fit_to_submission(given, submission);
  const ExerciseRun run = run_case(assignment, home, {submission, build}, asked);
  return make_report(assignment, submission, build, {run.judged});
}

Report grade_case_fully(const Assignment& given, const Submission& submission, const Home& home,
                        const Build& build, const Case& asked) {
  const Assignment assignment = fit_to_submission(given, submission);
  const Candidate candidate{submission, build};
  const ExerciseRubric& rubric = *assignment.find(asked.exercise);
  ExerciseRun run = run_case(assignment, home, candidate, asked);
  if (!is_all_right(run.judged) && has_callees(asked, rubric)) {
    const ExerciseRun whole = run_exercise(assignment, home, candidate, rubric);
    run_with_right_callees(assignment, home, candidate, whole, run);
  }
  run_again(assignment, home, candidate, {}, run);
  return make_report(assignment, submission, build, {run.judged});
}

Case shown_case(const Assignment& given, const Submission& submission, const Home& home,
                const Build& build, const Case& asked) {
  const Assignment assignment = fit_to_submission(given, submission);
  return run_case(assignment, home, {submission, build}, asked).judged.cases.at(0).asked;
}

}  // namespace meshgrade
