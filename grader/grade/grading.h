#pragma once

#include <functional>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/build/build.h"
#include "grader/build/home.h"
#include "grader/cases/case.h"
#include "grader/report/report.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// Told what is going on, for people who wait: "compiling 6 files".
using Progress = std::function<void(const std::string& what)>;

/// The exercises of these names, in the order of the assignment; all of them for no names.
/// @throws UserError if an exercise is not part of the assignment
std::vector<const ExerciseRubric*> choose_exercises(const Assignment& assignment,
                                                    const std::vector<std::string>& names);

/// The whole way from a submission to its report. `exercises` names those to grade; empty: all.
/// @throws UserError if an exercise is not part of the assignment
/// @throws GraderError if the grader itself fails
Report grade(const Assignment& assignment, const Submission& submission, const Home& home,
             const std::vector<std::string>& exercises, const Progress& progress);

/// Runs and judges a single case, in a process of its own.
/// @return a report of one exercise with this one case; its points mean nothing
/// @throws GraderError if the grader itself fails
Report grade_case(const Assignment& assignment, const Submission& submission, const Home& home,
                  const Build& build, const Case& asked);

/// The same with all that grade() does for a case that fails: a second run with a right
/// solution of the exercises that it needs.
Report grade_case_fully(const Assignment& assignment, const Submission& submission,
                        const Home& home, const Build& build, const Case& asked);

/// The case as the report shows it: smaller, if it fails and a smaller one does so as well.
/// @throws GraderError if the grader itself fails
Case shown_case(const Assignment& assignment, const Submission& submission, const Home& home,
                const Build& build, const Case& asked);

}  // namespace meshgrade
