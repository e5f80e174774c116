#pragma once

#include <string>

#include "grader/base/protocol.h"
#include "grader/worker/patience.h"
#include "grader/worker/result_file.h"

namespace meshgrade {

/// The child ends with this after it has written down by itself how its task ended.
constexpr int kTaskRecordedStatus = 90;
/// The child ends with this after it has noted a signal in the shared state.
constexpr int kSignalNotedStatus = 92;

/// Loads what telling a stack needs, so that it can be told in a handler of signals. To be
/// called before the first child is made: each of them would load it again.
void prepare_backtraces();

/// Runs the tasks from the first that is not done, but for those of the families that have used
/// up the patience. Never returns: ends the process.
[[noreturn]] void run_tasks(const TaskList& list, const Patience& patience,
                            SharedState& shared);

/// Writes down that the standard library refused a call in the task under way, and ends the
/// process. Returns if there is none: a constructor of a global object may fail before.
void library_check_failed(const std::string& what);

/// Completes the frame with what was printed, writes it, and counts its task as done.
void write_end(EndFrame frame, SharedState& shared, std::uint64_t limit);

}  // namespace meshgrade
