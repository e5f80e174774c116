#pragma once

#include "grader/submission/submission.h"

namespace meshgrade {

/// Finds out for which skeleton the files were written, from their text: `namespace CGL` or
/// "student_code.h" mean Berkeley's, and the form of the Bezier functions tells the year.
///
/// In a homework for Berkeley's skeleton, sorts out the course's own files that came along: its
/// programs are left out, and its mesh and Bezier headers give way to those of include/dropin.
/// Graded functions that stand in these headers become sources of their own. Adds a note on
/// each.
void settle_dialect(Submission& submission);

}  // namespace meshgrade
