#pragma once

// Written for C++17: the worker has it as well.

#include <sys/types.h>

namespace meshgrade {

/// In a process that was just forked: it is to die when its parent dies, so that nothing goes
/// on when the grader is killed. Ends it with `status` if the parent is dead already. Does
/// nothing where the system has no such thing (macOS).
void die_with(pid_t parent, int status = 1);

}  // namespace meshgrade
