#pragma once

#include <vector>

#include "grader/build/build.h"
#include "grader/cases/case.h"
#include "grader/run/outcome.h"

namespace meshgrade {

/// Whether cases share a process, which is fast, or have one each, which shows whether a
/// solution keeps state from one call to the next.
enum class Company { kTogether, kAlone };

/// What the worker reads: these cases, as an open file at its start.
/// @throws GraderError if it cannot be written
FileDescriptor make_task_file(const std::vector<const Case*>& cases, const Limits& limits,
                              Company company);

/// The limits of a run after another one that has waited for code without an end. A good
/// solution needs a hundredth of them.
Limits less_time(Limits limits);

/// Runs all cases in one worker, one after the other; `fresh` ones in a second one, each in a
/// process of its own. A case that kills the worker loses only itself. What the student's code
/// does is never the grader's fault: the result has one Outcome for each case, whatever
/// happens.
///
/// Cases of one group that call the same functions are a family. A family that runs out of time
/// again and again is given up, and the others go on. When one case spoils the run for all, by
/// writing over the results for example, each family gets a worker of its own: so no function
/// loses anything by what another does.
/// @throws GraderError if the worker cannot be started
std::vector<Outcome> run_cases(const Build& build, const std::vector<const Case*>& cases,
                               const Limits& limits, Company company);

}  // namespace meshgrade
