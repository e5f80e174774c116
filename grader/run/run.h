#pragma once

#include <vector>

#include "grader/build/build.h"
#include "grader/cases/case.h"
#include "grader/run/outcome.h"

namespace meshgrade {

/// Runs all cases in one worker, one after the other. A case that kills the worker loses only
/// itself. What the student's code does is never the grader's fault: the result has one
/// Outcome for each case, whatever happens.
/// @throws GraderError if the worker cannot be started
std::vector<Outcome> run_cases(const Build& build, const std::vector<const Case*>& cases,
                               const Limits& limits);

}  // namespace meshgrade
