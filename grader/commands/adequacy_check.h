#pragma once

#include "grader/mutants/adequacy.h"

namespace meshgrade {

/// Grades the mutants and variants of the solutions next to the program's sources.
Adequacy measure_standard_adequacy(const AdequacyOptions& options, const JobProgress& progress);

/// `dev-check --mutants`: measures how well the grader grades, prints the figures, and writes
/// docs/adequacy.md if enough was graded, or `page` if one is named.
/// @return the exit code: 0 if all is proven, 1 if not
int check_adequacy(const AdequacyOptions& options, const std::string& page);

/// `dev-check --mistakes`: grades the submissions with known mistakes, `jobs` at a time, and
/// writes what is said of them into docs/adequacy.md. @return the exit code
int write_known_mistakes(unsigned jobs);

}  // namespace meshgrade
