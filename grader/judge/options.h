#pragma once

#include <string>
#include <vector>

#include "grader/assignment/assignment.h"

namespace meshgrade {

/// @throws UserError if the rubric sets an option that is not in the list
void refuse_unknown_options(const ExerciseRubric& rubric,
                            const std::vector<std::string>& known);

/// The value of an option, which must be one of `choices`; the first of them if it is not set.
/// @throws UserError that names the option and the choices
std::string choose_option(const ExerciseRubric& rubric, const std::string& option,
                          const std::vector<std::string>& choices);

}  // namespace meshgrade
