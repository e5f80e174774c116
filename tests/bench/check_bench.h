#pragma once

#include <filesystem>

#include "tests/bench/results.h"

namespace meshgrade::bench {

/// `<program> check reference`, warm, against the bare compile of the same files with the same
/// compiler and flags, without precompiled headers. Throws GraderError if a compile or the
/// check fails.
Table run_check_bench(const std::filesystem::path& program, bool quick);

std::vector<Goal> check_goals();

}  // namespace meshgrade::bench
