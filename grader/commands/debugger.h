#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/base/process.h"
#include "grader/build/build.h"

namespace meshgrade {

/// @throws UserError that says how to install gdb, if it is missing
void require_debugger();

/// What a session with the debugger begins with.
struct DebugSession {
  std::vector<std::string> functions;  ///< where to stop: "HalfedgeMesh::flipEdge"
  std::filesystem::path sources;       ///< where gdb finds the student's files
  std::filesystem::path printers;      ///< a Python file: how to print handles
  std::string corners;                 ///< letters of vertices for it: "a=3 b=0 c=1 d=2"
};

/// Runs a worker on these tasks in gdb, which stops at each call of the functions, such as
/// "HalfedgeMesh::flipEdge", and takes commands from the keyboard until the person ends it.
/// What the student's code prints goes to the terminal, if there is one.
/// @return gdb's exit status
/// @throws GraderError if gdb cannot be started
int run_debugger(const Build& build, const FileDescriptor& tasks, const DebugSession& session);

}  // namespace meshgrade
