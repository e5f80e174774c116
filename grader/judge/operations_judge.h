#pragma once

#include "grader/cases/mesh_input.h"
#include "grader/judge/judge.h"
#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// The mesh that the worker begins with.
MeshDump first_mesh(const OperationsInput& input);

/// Judges the steps of an OperationsInput: after each flip or split all mesh rules, the numbers
/// of elements, and the surface that it should give, whatever the numbering. Stops at the first
/// step that is wrong, since what follows starts from a wrong mesh.
void judge_operations(const JudgeTask& task, CaseJudgement& judgement);

/// Shows the neighbourhood as it was when a fault stopped the code within an operation; all
/// operations before it are right.
/// @throws WireError if the interrupted state is malformed
void show_stopped_operation(const JudgeTask& task, Finding& finding);

/// The letters of the corners around the first edge, by the numbers of the vertices: "a=3 b=0
/// c=1 d=2", with "m=4" for the vertex that a split makes.
std::string corner_letters(const OperationsInput& input);

}  // namespace meshgrade
