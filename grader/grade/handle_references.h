#pragma once

#include <string>

#include "grader/report/report.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// The first `HalfedgeIter& h = ...` in a source, as "line 20: HalfedgeIter& ca = h->next()";
/// empty if there is none. Such a reference is another name for a pointer of the mesh and
/// changes with it. References of `auto` count if they are given what a pointer's function
/// returns.
std::string find_handle_reference(const std::string& source);

/// If several pointers of a mesh are wrong in an exercise and the file that holds it has a
/// handle reference, says so in the notes: it may be why.
void note_handle_references(const Submission& submission,
                            const std::vector<std::string>& functions,
                            JudgedExercise& exercise);

}  // namespace meshgrade
