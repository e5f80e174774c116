#pragma once

// What compiler and linker say, in words for students.

#include <string>

#include "grader/base/process.h"

namespace meshgrade {

/// True if the compiler did not come to an end by itself: it was killed, or found a fault of
/// its own. No fault of the code that it compiled, whatever is in it.
bool is_dead_compiler(const ProcessResult& result);

/// Why the linker refused a file, if another one defines the same: "helper is defined in
/// edge_flip.cpp as well; make one of them static, or rename it"; empty otherwise.
std::string explain_link_error(const std::string& messages);

}  // namespace meshgrade
