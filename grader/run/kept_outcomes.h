#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/build/build.h"
#include "grader/run/outcome.h"

namespace meshgrade {

/// Digest of all that outcomes come from; empty where none are kept.
/// @param functions  that the cases call
/// @param tasks      the bytes that the worker reads
std::string identity_of_run(const Build& build, const std::vector<std::string>& functions,
                            const std::string& tasks, const Limits& limits);

/// Outcomes of the same tasks with the same worker, if they were kept.
std::optional<std::vector<Outcome>> find_kept_outcomes(const Build& build,
                                                       const std::string& identity);

/// Keeps outcomes, unless any of them depends on how busy the machine was: then all of them
/// have to be run again.
void keep_outcomes(const Build& build, const std::string& identity,
                   const std::vector<Outcome>& outcomes);

}  // namespace meshgrade
