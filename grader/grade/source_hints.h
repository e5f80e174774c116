#pragma once

#include <string>
#include <vector>

#include "grader/report/report.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// Where the numbers of an exercise cannot tell a division of whole numbers from another
/// mistake, its text can: keeps the one or the other of what findings name. Looks into the
/// files that hold one of `functions`.
void tell_apart_by_source(const Submission& submission,
                          const std::vector<std::string>& functions, JudgedExercise& exercise);

/// Says of cases that pass alone which variable keeps its value from one call to the next, if
/// there is one.
void name_static_variable(const Submission& submission,
                          const std::vector<std::string>& functions, JudgedExercise& exercise);

/// Says of a function that is "not implemented" if it is written, but without its class.
void name_free_function(const Submission& submission, const std::vector<std::string>& functions,
                        CaseJudgement& judgement);

/// Whether whole numbers are divided: "3 / 8", "3 / (8 * n)", but not "3 / 8.0".
bool divides_whole_numbers(const std::string& source);

/// "line 4: static int calls = 0"; empty if there is no variable that outlives a call.
std::string find_static_variable(const std::string& source);

/// The line, from 1, in which a function is defined that has this name and no class; 0 if there
/// is none.
int find_free_function(const std::string& source, const std::string& name);

}  // namespace meshgrade
