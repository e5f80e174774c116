#pragma once

#include <string>

#include "grader/assignment/assignment.h"
#include "grader/build/home.h"
#include "grader/grade/grading.h"
#include "grader/report/report.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// A case that ran once more under the address and undefined-behaviour sanitizers.
struct SanitizedReplay {
  Report report;    ///< of one exercise with this one case
  std::string log;  ///< what the sanitizers say, cleaned; empty if they found nothing
};

/// Compiles the submission for the sanitizers, which takes ten times as long, and runs a case.
/// What it may do is less narrow than in grading: for one's own code only.
/// @throws GraderError if the grader itself fails
SanitizedReplay replay_sanitized(Assignment assignment, const Submission& submission,
                                 const Home& home, const Case& asked);

/// Lets the sanitizers say what the first crash of a report is, if there is one and they are
/// there: their sentence stands in its finding then.
void explain_first_crash(const Assignment& assignment, const Submission& submission,
                         const Home& home, const Progress& progress, Report& report);

}  // namespace meshgrade
