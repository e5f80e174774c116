#pragma once

#include "grader/judge/judge.h"
#include "grader/operations/local_operation.h"

namespace meshgrade {

/// The judge of an exercise that is about one operation.
/// @throws UserError if the rubric sets an option that there is not
ExerciseJudge local_operation_judge(const ExerciseRubric& rubric,
                                    const LocalOperation& operation);

}  // namespace meshgrade
