#pragma once

#include <string>
#include <vector>

#include "grader/report/report.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// Notes what homework for Scotty3D is not to do any more when it is handed in, and that takes
/// no points here: calls of validate() and describe() in a graded function, which look at the
/// whole mesh, and what is printed in cases that pass. Other submissions are left alone.
void note_left_over_calls(const Submission& submission,
                          const std::vector<std::string>& functions, JudgedExercise& exercise);

}  // namespace meshgrade
