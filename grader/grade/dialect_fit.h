#pragma once

#include "grader/assignment/assignment.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// The assignment as it is asked of a homework for this skeleton: of Berkeley's only what that
/// skeleton promises, which is curves of 4 points and nets of 4 x 4, and of each year only the
/// functions that it has; of Scotty3D's with its names of functions, and a tolerance for
/// positions that were computed in float. Groups and points stay.
Assignment fit_to_dialect(Assignment assignment, Dialect dialect);

}  // namespace meshgrade
