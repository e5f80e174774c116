#include "grader/app/grading.h"

#include <algorithm>

#include "grader/app/compile_blame.h"
#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/build/build.h"
#include "grader/cases/case_list.h"
#include "grader/judge/judge.h"
#include "grader/run/run.h"

namespace meshgrade {
namespace {

/// So many failed cases of an exercise are explained in full; the others get their verdict.
constexpr std::size_t kMostExplained = 8;

/// Judges cases in order, the first `explained` failures among them in full.
std::vector<CaseJudgement> judge_all(const Assignment& assignment, const ExerciseRubric& rubric,
                                     const std::vector<const Case*>& cases,
                                     const std::vector<Outcome>& outcomes,
                                     Conventions& conventions, std::size_t explained) {
  const ExerciseJudge judge = find_exercise_judge(rubric);
  std::vector<CaseJudgement> judgements;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    judgements.push_back(
        judge_case(judge, {*cases[i], outcomes[i], rubric, assignment.tolerance, explained > 0},
                   conventions));
    if (judgements.back().verdict == Verdict::kFailed && explained > 0) --explained;
  }
  return judgements;
}

bool deserves_second_run(const CaseJudgement& judgement) {
  switch (judgement.verdict) {
    case Verdict::kFailed:
    case Verdict::kCrashed:
    case Verdict::kOutOfSteps:
    case Verdict::kOutOfMemory:
      return true;
    default:
      return false;
  }
}

/// Runs failed cases once more, each in a process of its own, and says so where that helps.
void run_again_alone(const Assignment& assignment, const ExerciseRubric& rubric,
                     const Build& build, const std::vector<Case>& cases,
                     Conventions conventions, std::vector<CaseJudgement>& judgements) {
  std::vector<const Case*> failed;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!deserves_second_run(judgements[i])) continue;
    failed.push_back(&cases[i]);
    places.push_back(i);
  }
  if (failed.empty()) return;
  const std::vector<Outcome> outcomes =
      run_cases(build, failed, assignment.limits, Company::kAlone);
  const auto alone = judge_all(assignment, rubric, failed, outcomes, conventions, 0);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    if (alone[i].verdict != Verdict::kPassed) continue;
    judgements[places[i]].note =
        "this case passes when it is run alone: the code keeps something from one call to the "
        "next, in a global or static variable?";
  }
}

bool has_failure(const JudgedExercise& exercise) {
  return std::any_of(exercise.cases.begin(), exercise.cases.end(), [](const JudgedCase& c) {
    return c.judgement.verdict != Verdict::kPassed &&
           c.judgement.verdict != Verdict::kNotImplemented;
  });
}

JudgedExercise judge_exercise(const Assignment& assignment, const Submission& submission,
                              const Build& build, const ExerciseRubric& rubric,
                              const std::vector<Case>& cases,
                              const std::vector<Outcome>& outcomes) {
  const ExerciseJudge judge = find_exercise_judge(rubric);
  Conventions conventions = judge.conventions;
  std::vector<const Case*> pointers;
  for (const Case& c : cases)
    pointers.push_back(&c);
  std::vector<CaseJudgement> judgements =
      judge_all(assignment, rubric, pointers, outcomes, conventions, kMostExplained);
  run_again_alone(assignment, rubric, build, cases, conventions, judgements);
  JudgedExercise judged;
  judged.rubric = &rubric;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    blame_compilation(assignment, submission, build, judge, judgements[i]);
    judged.cases.push_back(
        {cases[i], std::move(judgements[i]), outcomes[i].output, outcomes[i].output_bytes});
  }
  if (conventions.size() == 1 && !has_failure(judged)) {
    judged.notes.push_back("found: " + *conventions.begin());
  }
  return judged;
}

/// Points from an exercise that fails to the ones that it calls and that fail as well.
void point_to_causes(std::vector<JudgedExercise>& exercises) {
  for (JudgedExercise& exercise : exercises) {
    if (!has_failure(exercise)) continue;
    for (const JudgedExercise& other : exercises) {
      const auto& needs = exercise.rubric->needs;
      const bool needed =
          std::find(needs.begin(), needs.end(), other.rubric->name) != needs.end();
      if (!needed || !has_failure(other)) continue;
      exercise.notes.push_back("your own " + other.rubric->name +
                               " is part of this and fails: see there first");
    }
  }
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

Report grade(const Assignment& assignment, const Submission& submission, const Home& home,
             const std::vector<std::string>& exercises, const Progress& progress) {
  const std::vector<const ExerciseRubric*> chosen = choose_exercises(assignment, exercises);
  progress("compiling " + plural(submission.sources.size(), "file"));
  const Build build = build_submission(submission, home, assignment.limits);
  std::vector<JudgedExercise> judged;
  for (const ExerciseRubric* rubric : chosen) {
    const std::vector<Case> cases = make_cases(assignment, *rubric, home.meshes);
    progress(rubric->name + ": " + plural(cases.size(), "case"));
    std::vector<const Case*> pointers;
    for (const Case& c : cases)
      pointers.push_back(&c);
    const std::vector<Outcome> outcomes =
        run_cases(build, pointers, assignment.limits, Company::kTogether);
    judged.push_back(judge_exercise(assignment, submission, build, *rubric, cases, outcomes));
  }
  point_to_causes(judged);
  return make_report(assignment, submission, build.files, judged);
}

Report grade_case(const Assignment& assignment, const Submission& submission,
                  const Build& build, const Case& asked) {
  const ExerciseRubric& rubric = *assignment.find(asked.exercise);
  const ExerciseJudge judge = find_exercise_judge(rubric);
  Conventions conventions = judge.conventions;
  const Outcome outcome = run_cases(build, {&asked}, assignment.limits, Company::kAlone).at(0);
  CaseJudgement judgement =
      judge_case(judge, {asked, outcome, rubric, assignment.tolerance}, conventions);
  blame_compilation(assignment, submission, build, judge, judgement);
  JudgedExercise judged;
  judged.rubric = &rubric;
  judged.cases.push_back({asked, std::move(judgement), outcome.output, outcome.output_bytes});
  return make_report(assignment, submission, build.files, {judged});
}

}  // namespace meshgrade
