#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/base/process.h"
#include "grader/build/build.h"

namespace meshgrade {

/// @throws UserError that says how to install gdb, if it is missing
void require_debugger();

/// Runs a worker on these tasks in gdb, which stops at each call of the functions, such as
/// "HalfedgeMesh::flipEdge", and takes commands from the keyboard until the person ends it.
/// What the student's code prints goes to the terminal, if there is one.
/// @param sources where gdb finds the student's files
/// @return gdb's exit status
/// @throws GraderError if gdb cannot be started
int run_debugger(const Build& build, const FileDescriptor& tasks,
                 const std::vector<std::string>& functions,
                 const std::filesystem::path& sources);

}  // namespace meshgrade
