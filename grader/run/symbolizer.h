#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "grader/build/build.h"
#include "grader/run/outcome.h"

namespace meshgrade {

/// Finds the functions, files and lines of code addresses of the worker by binutils' addr2line.
/// An address in inlined code has several frames, innermost first. Without addr2line, or for a
/// program that it cannot read, the result is empty: a place is a help, not a need.
std::map<std::uint64_t, std::vector<StackFrame>> symbolize(
    const Build& build, const std::set<std::uint64_t>& addresses);

}  // namespace meshgrade
