#pragma once

// How long the worker waits for a task. Code that never ends would cost the whole limit in
// every task: what has run out of time once most likely does so again.

#include <algorithm>
#include <cstdint>
#include <map>

#include "grader/base/protocol.h"

namespace meshgrade {

/// Which families of tasks have run out of time, and what the others may take.
class Patience {
 public:
  void note_timeout(std::uint32_t family) { ++timeouts_[family]; }

  /// Whether tasks of this family are not run any more.
  bool is_used_up(std::uint32_t family) const {
    const auto found = timeouts_.find(family);
    return found != timeouts_.end() && found->second >= kMostTimeouts;
  }

  /// What is left of a time limit of a task, in milliseconds: after the first timeout a
  /// quarter, and what its steps may take. That is still hundreds of times what a good solution
  /// needs. 0, no limit, stays 0.
  std::uint32_t limit(const Task& task, std::uint32_t milliseconds) const {
    if (timeouts_.empty()) return milliseconds;
    constexpr std::uint32_t kLeast = 500;
    constexpr std::uint64_t kStepsPerMillisecond = 10'000;
    const std::uint64_t hurried =
        std::max(kLeast, milliseconds / 4) + task.step_budget / kStepsPerMillisecond;
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(milliseconds, hurried));
  }

 private:
  std::map<std::uint32_t, std::uint32_t> timeouts_;  ///< by family
};

}  // namespace meshgrade
