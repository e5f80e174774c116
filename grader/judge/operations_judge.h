#pragma once

#include "grader/cases/mesh_input.h"
#include "grader/judge/judge.h"

namespace meshgrade {

/// Judges the steps of an OperationsInput: after each flip or split all mesh rules, the numbers
/// of elements, and the surface that it should give, whatever the numbering. Stops at the first
/// step that is wrong, since what follows starts from a wrong mesh.
void judge_operations(const JudgeTask& task, CaseJudgement& judgement);

/// Shows the neighbourhood as it was when a fault stopped the code within an operation; all
/// operations before it are right.
/// @throws WireError if the interrupted state is malformed
void show_stopped_operation(const JudgeTask& task, Finding& finding);

}  // namespace meshgrade
