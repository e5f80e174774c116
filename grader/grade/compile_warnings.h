#pragma once

#include "grader/build/build.h"
#include "grader/judge/judge.h"
#include "grader/report/report.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// Where cases of an exercise fail, adds what the compiler warned of in the functions that they
/// call, the student's own helpers among them. That a function can end without `return` becomes
/// the first finding; other warnings become notes of the exercise.
void add_compiler_warnings(const Submission& submission, const Build& build,
                           const ExerciseJudge& judge, JudgedExercise& exercise);

}  // namespace meshgrade
