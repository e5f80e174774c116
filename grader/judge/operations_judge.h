#pragma once

#include "grader/cases/mesh_input.h"
#include "grader/judge/judge.h"

namespace meshgrade {

/// Judges the steps of an OperationsInput: after each flip or split all mesh rules, the numbers
/// of elements, and the surface that it should give, whatever the numbering. Stops at the first
/// step that is wrong, since what follows starts from a wrong mesh.
void judge_operations(const JudgeTask& task, CaseJudgement& judgement);

/// Judges a single step from a mesh that keeps all rules; of `task`, only the group, the
/// tolerance and whether to explain matter. `step.edge` is the edge that was asked for.
/// @throws WireError if the edge is not one of `before`
void judge_operation(const JudgeTask& task, const MeshDump& before, OperationKind kind,
                     const OperationStep& step, CaseJudgement& judgement);

}  // namespace meshgrade
