#pragma once

#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// The assignment as it is asked of a homework for this skeleton: of Berkeley's only what that
/// skeleton promises, which is curves of 4 points and nets of 4 x 4, and of each year only the
/// functions that it has; of Scotty3D's with its names of functions, and a tolerance for
/// positions that were computed in float. Groups and points stay, but for Scotty3D until Spring
/// 2022: exercises and groups that these years did not ask for go, and where they had no rule,
/// whoever refuses is right as well (operations/course_rules.h).
///
/// An assignment may be fitted twice.
Assignment fit_to_dialect(Assignment assignment, Dialect dialect);

/// The same for a homework, or for all of a class: what came in the last of the years of its
/// skeleton is asked if one of them defines it.
Assignment fit_to_submission(Assignment assignment, const Submission& submission);
Assignment fit_to_class(Assignment assignment, const std::vector<Submission>& submissions);

}  // namespace meshgrade
