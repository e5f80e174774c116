#pragma once

#include "grader/assignment/assignment.h"
#include "grader/build/build.h"
#include "grader/judge/judge.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// Tells functions that do not compile from those that are not written: both answer "not
/// implemented". Changes the verdict and the note of such a case and leaves others alone.
void blame_compilation(const Assignment& assignment, const Submission& submission,
                       const Build& build, const ExerciseJudge& judge, const Case& asked,
                       CaseJudgement& judgement);

}  // namespace meshgrade
