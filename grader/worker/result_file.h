#pragma once

// The result file: the only thing that leaves the worker. A list of frames, each with its
// length in front. C++17.
//
// Several processes write to it, one after the other: the process that runs student code, and
// its parent when that one has died. The length of the part that is known to be whole is kept
// in shared memory, so that a frame that was cut off by a crash is overwritten by the next.

#include <atomic>
#include <cstdint>
#include <string>

#include "grader/base/protocol.h"

namespace meshgrade {

/// Memory that the parent and the child see both.
struct SharedState {
  std::atomic<std::uint64_t> result_size{0};  ///< bytes of the result file that are whole
  std::atomic<std::uint32_t> tasks_done{0};
  std::atomic<Ending> last_ending{Ending::kDone};  ///< of the last task that is done
  std::atomic<std::int32_t> signal{0};             ///< the signal that the child caught
  std::atomic<std::uint32_t> stack_size{0};
  std::uint64_t stack[64] = {};  ///< where the child was when it caught it
};

/// Appends one frame. @return false if it could not be written, or would make the file larger
/// than `limit` bytes
bool append_frame(int file, SharedState& shared, const std::string& bytes, std::uint64_t limit);

}  // namespace meshgrade
