#pragma once

#include "grader/judge/finding.h"
#include "grader/run/outcome.h"

namespace meshgrade {

/// The finding for an outcome that ends with Ending::kLibraryCheck: what the standard library
/// refused, in plain words, with the student's stack.
Finding library_check_finding(const Outcome& outcome);

}  // namespace meshgrade
