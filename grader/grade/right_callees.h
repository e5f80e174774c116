#pragma once

#include "grader/grade/exercise_run.h"

namespace meshgrade {

/// An exercise can have several functions, of which one calls another: evaluate1D calls
/// evaluateStep. Each is judged on its own: where a function fails and one that it may call
/// fails in cases of its own, its cases run once more with a right solution of that one. A case
/// counts as passed if it passes in either run, and otherwise the second run tells what is
/// wrong. Without the reference only says so.
///
/// @param whole  the same exercise with all its cases: it tells which functions fail
/// @throws GraderError if the grader itself fails
void run_with_right_callees(const Assignment& assignment, const Home& home,
                            const Candidate& candidate, const ExerciseRun& whole,
                            ExerciseRun& run);

/// Whether the case of this run is about a function that may call another of its exercise.
bool has_callees(const Case& asked, const ExerciseRubric& rubric);

}  // namespace meshgrade
