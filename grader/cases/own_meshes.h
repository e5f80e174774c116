#pragma once

// Cases on meshes of the instructor's own: [[exercise.group.mesh]] of an assignment.

#include "grader/cases/case_list.h"

namespace meshgrade {

/// Reads all own meshes that are there, and checks them against what the exercise asks for.
/// @throws UserError that names the assignment's line if one cannot be read or is no surface of
///         triangles, if a named edge is not there, or if the exercise has no use for it
void check_own_meshes(const Assignment& assignment);

/// Adds the cases of the own meshes of all groups: those that are handed out, or the hidden
/// ones. Hidden ones that are not there have none.
/// @throws UserError as check_own_meshes does
void add_own_meshes(CaseMaker& maker, const ExerciseRubric& rubric, bool hidden);

}  // namespace meshgrade
