#pragma once

#include <string>

#include "grader/assignment/assignment.h"
#include "grader/report/report.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// The report in the form of GCC's messages, for editors that jump to them:
///
///     my_homework/edge_flip.cpp:14:3: error: edge_flip: h3.next: expected ... [twin-opposite]
///     my_homework/edge_flip.cpp:14:3: note: look at h3.next
///
/// What the compiler said of files that do not compile comes first; then of each exercise that
/// lost points its first finding, where the student's own stack tells a line at that line, else
/// at the function that the exercise asks for. What is only not written yet, or only extra
/// credit, is a warning. The last line tells the points. Files are named as one reaches them
/// from where the program was called, in an archive by their names.
/// @throws UserError if an exercise of the report has an option that does not exist
std::string to_gcc(const Report& report, const Submission& submission,
                   const Assignment& assignment);

}  // namespace meshgrade
