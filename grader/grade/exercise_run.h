#pragma once

#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/build/build.h"
#include "grader/build/home.h"
#include "grader/cases/case.h"
#include "grader/report/report.h"
#include "grader/run/outcome.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// A submission with the worker that was built from it.
struct Candidate {
  const Submission& submission;
  const Build& build;
};

/// One exercise on its way: what was asked, what came, and what the judge says.
struct ExerciseRun {
  std::vector<Case> cases;
  std::vector<Outcome> outcomes;  ///< one for each case
  JudgedExercise judged;
};

/// Runs all cases of an exercise and judges them.
/// @throws GraderError if the grader itself fails
ExerciseRun run_exercise(const Assignment& assignment, const Home& home,
                         const Candidate& candidate, const ExerciseRubric& rubric);

/// Whether any case fails, and nothing else: no case is run again, explained or made smaller.
/// @throws GraderError if the grader itself fails
bool fails_at_once(const Assignment& assignment, const Home& home, const Candidate& candidate,
                   const ExerciseRubric& rubric);

/// Judges outcomes that are there already. Cases that fail run once more alone, and the first
/// of them are made smaller where that is possible.
/// @throws GraderError if the grader itself fails
JudgedExercise judge_exercise(const Assignment& assignment, const Home& home,
                              const Candidate& candidate, const ExerciseRubric& rubric,
                              const std::vector<Case>& cases,
                              const std::vector<Outcome>& outcomes);

/// Whether any case fails. What is not implemented does not count as failing.
bool has_failure(const JudgedExercise& exercise);

/// Whether every case is passed, but for those that do not count.
bool is_all_right(const JudgedExercise& exercise);

/// The same of the cases in groups that are no extra credit.
bool is_required_right(const JudgedExercise& exercise);

}  // namespace meshgrade
