#pragma once

#include <string_view>
#include <vector>

#include "grader/base/protocol.h"

namespace meshgrade {

/// One task as the result file tells it.
struct TaskResult {
  bool ended = false;
  std::vector<std::string> steps;
  EndFrame end;
};

/// Reads a result file. Trusts nothing in it.
/// @return one entry for each of the `tasks` tasks; those that the file does not mention have
///         not ended
/// @throws WireError if the file is not a sequence of frames in the order of the tasks
std::vector<TaskResult> read_results(std::string_view bytes, std::size_t tasks);

}  // namespace meshgrade
