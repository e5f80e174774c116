#pragma once

#include "tests/bench/bare_compile.h"
#include "tests/bench/results.h"

namespace meshgrade::bench {

/// `<program> batch` on a class, in real seconds per submission on all cores, sandbox on.
/// Beside it: the bare compile of the same files, and the usual way to grade homework in C++,
/// which is a CMake configuration, a build and a run of GoogleTest for each submission. A
/// student's hand-in is the reference with one file taken from a known-wrong submission. Throws
/// GraderError if one of the programs fails.
Table run_class_bench(const Programs& programs, bool quick);

std::vector<Goal> class_goals();

}  // namespace meshgrade::bench
