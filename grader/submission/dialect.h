#pragma once

#include "grader/submission/submission.h"

namespace meshgrade {

/// Finds out for which skeleton the files were written, from their text: `namespace CGL` or
/// "student_code.h" mean Berkeley's, and the form of the Bezier functions tells the year;
/// functions of Halfedge_Mesh mean Scotty3D, and whether pointers are functions there tells the
/// years.
///
/// In a homework for one of these skeletons, sorts out the course's own files that came along:
/// its programs are left out, and its headers give way to those of include/dropin or
/// include/dropin_scotty3d and include/dropin_scotty3d_2020. In one for Berkeley's, graded
/// functions that stand in these headers become sources of their own. Adds a note on each.
void settle_dialect(Submission& submission);

}  // namespace meshgrade
