#pragma once

#include "tests/bench/bare_compile.h"
#include "tests/bench/results.h"

namespace meshgrade::bench {

/// What a new user pays once: the first `check reference` in a clean copy of the sources, with
/// the packages there already. Seconds of processor time, and how many objects were compiled.
/// One round of some minutes for each program. Throws GraderError if the check fails.
Table run_setup_bench(const Programs& programs);

std::vector<Goal> setup_goals();

}  // namespace meshgrade::bench
