#pragma once

#include "tests/bench/bare_compile.h"
#include "tests/bench/results.h"

namespace meshgrade::bench {

/// What a student waits for, in real seconds: `check` with nothing kept of earlier checks, of
/// the same files again, after one of six files was changed, of code that never ends; and
/// `replay` of one case. Beside it the bare compile of the same files with the same compiler
/// and flags, without precompiled headers. Throws GraderError if a compile or a check fails.
Table run_check_bench(const Programs& programs, bool quick);

std::vector<Goal> check_goals();

}  // namespace meshgrade::bench
