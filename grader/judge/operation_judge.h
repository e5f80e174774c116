#pragma once

#include <string>

#include "grader/cases/mesh_input.h"
#include "grader/judge/judge.h"
#include "grader/judge/neighbourhood_figure.h"

namespace meshgrade {

/// Judges one flip or split of a mesh that keeps all rules: the rules, the numbers of elements,
/// and the surface that it should give, whatever the numbering.
///
/// @param where  which operation of how many, for the findings; empty if it is the only one
void judge_step(const JudgeTask& task, const MeshDump& before, Operation operation,
                const OperationStep& step, std::string where, CaseJudgement& judgement);

/// The same for a step that belongs to no case; of `task`, only the group, the tolerance and
/// whether to explain matter. `step.edge` is the edge that was asked for.
/// @throws WireError if the edge is not one of `before`
void judge_operation(const JudgeTask& task, const MeshDump& before, OperationKind kind,
                     const OperationStep& step, CaseJudgement& judgement);

/// Where the pointers led when the code was stopped within an operation on `edge`, an edge of
/// `before`, which keeps all rules; `stopped` may be broken in any way.
NeighbourhoodFigure figure_of_stop(const MeshDump& before, OperationKind kind, Ref edge,
                                   const MeshDump& stopped);

}  // namespace meshgrade
