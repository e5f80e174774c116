#pragma once

#include <string>

#include "grader/build/home.h"

namespace meshgrade {

/// A text that changes when anything of the grader does that a report may depend on: this
/// program, the worker that submissions are linked with, the shared headers, the meshes, and
/// the compiler.
/// @throws UserError if one of these files cannot be read
std::string grader_identity(const Home& home);

}  // namespace meshgrade
