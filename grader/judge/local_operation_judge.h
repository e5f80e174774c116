#pragma once

#include "grader/cases/local_operation_input.h"
#include "grader/judge/judge.h"
#include "grader/operations/local_operation.h"

namespace meshgrade {

/// The judge of an exercise that is about one operation.
/// @throws UserError if the rubric sets an option that there is not
ExerciseJudge local_operation_judge(const ExerciseRubric& rubric,
                                    const LocalOperation& operation);

/// Judges one operation.
/// @param before  keeps all mesh rules and is not degenerate
/// @param step    the elements that it names are there
void judge_local_step(const JudgeTask& task, const LocalOperation& operation,
                      const MeshDump& before, const LocalStep& step, const std::string& where,
                      CaseJudgement& judgement);

}  // namespace meshgrade
