#pragma once

#include <optional>

#include "grader/grade/exercise_run.h"

namespace meshgrade {

/// The smallest question found that the submission fails in the same way as `failed`: fewer
/// operations, fewer points, a simpler mesh. Nothing if none of the smaller ones fails.
/// What one of `all`, the cases of the exercise, asks anyway is not looked at.
/// @throws GraderError if the grader itself fails
std::optional<JudgedCase> shrink(const Assignment& assignment, const Home& home,
                                 const Candidate& candidate, const ExerciseRubric& rubric,
                                 const std::vector<Case>& all, const JudgedCase& failed);

}  // namespace meshgrade
