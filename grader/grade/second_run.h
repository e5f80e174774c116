#pragma once

#include <vector>

#include "grader/grade/exercise_run.h"

namespace meshgrade {

/// Loop subdivision calls the student's own flip and split. When these fail in what they must
/// do (extra credit aside), says so, and runs it once more with the reference's in their place,
/// so that each exercise is judged on its own: a case counts as passed if it passes in either
/// run; where it fails in both, what the first run found stays. Where the reference's contract
/// leaves a choice open that a caller may rely on (ExerciseJudge::choices), it counts as right
/// if it is so with one of them.
///
/// When they lack extra credit only, the same is done for what this exercise lacks besides its
/// required groups, and only if these all pass with the student's own. When they are right, and
/// yet more cases pass with one of the reference's in its place, says which one: it leaves
/// something else than its caller relies on. Without the reference only says so.
///
/// `run` is of an exercise that has not all cases passed; `needed` are the exercises that it
/// needs, judged.
/// @throws GraderError if the grader itself fails
void run_with_stand_ins(const Assignment& assignment, const Home& home,
                        const Candidate& candidate, const std::vector<JudgedExercise>& needed,
                        ExerciseRun& run);

}  // namespace meshgrade
