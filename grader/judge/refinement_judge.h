#pragma once

#include "grader/judge/judge.h"
#include "grader/judge/refinement_rules.h"

namespace meshgrade {

/// The judge of an exercise whose function computes where the vertices of the next level lie.
/// Compares with OpenSubdiv, level by level: of each level with what the function was given.
/// @throws UserError if the rubric sets an option
template <RefinementScheme kScheme>
ExerciseJudge refinement_judge(const ExerciseRubric& rubric, const std::string& function);

/// What is right, by OpenSubdiv.
/// @param mesh  keeps all mesh rules, all its elements are live, and no two edges have the same
///              ends
RefinedPoints right_points(const MeshDump& mesh, RefinementScheme scheme);

}  // namespace meshgrade
