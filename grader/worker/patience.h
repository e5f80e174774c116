#pragma once

// How long the worker waits for a task, and how much memory it may take. Code that never ends
// would cost the whole limit in every task: what has run out of time or memory once most likely
// does so again.

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>

#include "grader/base/protocol.h"

namespace meshgrade {

/// Which tasks have run out of time or memory, and what the others may take.
class Patience {
 public:
  void note_timeout(const Task& task) {
    if (++timeouts_[task.family] >= most_timeouts(task)) used_up_.insert(task.family);
    if (used_up_.count(task.family) != 0) endless_.insert(task.calls);
  }

  void note_out_of_memory(const Task& task) { hungry_.insert(task.calls); }

  /// Whether functions that this task calls, all the same ones, have run out of memory.
  bool is_hungry(const Task& task) const { return hungry_.count(task.calls) != 0; }

  /// What a task may take of memory, of a limit in bytes: an eighth if it is hungry. What takes
  /// gigabytes takes a second to do so, and the largest tasks need some 60 MB. 0, no limit,
  /// stays 0.
  std::uint64_t memory_limit(const Task& task, std::uint64_t limit) const {
    constexpr std::uint64_t kLeast = std::uint64_t{256} << 20U;
    return is_hungry(task) ? std::min(limit, std::max(kLeast, limit / 8)) : limit;
  }

  /// Whether tasks of this family are not run any more.
  bool is_used_up(std::uint32_t family) const { return used_up_.count(family) != 0; }

  /// What a task may take of the processor, in milliseconds: after the first timeout a quarter
  /// of its limit, and where a family of the same functions was given up a tenth; and what its
  /// steps may take. A good solution needs a hundredth of that. 0, no limit, stays 0.
  std::uint32_t cpu_limit(const Task& task) const {
    if (timeouts_.empty()) return task.cpu_ms;
    const bool endless = endless_.count(task.calls) != 0;
    return endless ? hurried(task, task.cpu_ms, 100, 10) : hurried(task, task.cpu_ms, 250, 4);
  }

  /// The same on the clock, where others may take the processor away.
  std::uint32_t wall_limit(const Task& task) const {
    return timeouts_.empty() ? task.wall_ms : hurried(task, task.wall_ms, 500, 4);
  }

 private:
  static std::uint32_t hurried(const Task& task, std::uint32_t limit, std::uint32_t least,
                               std::uint32_t part) {
    constexpr std::uint64_t kStepsPerMillisecond = 100'000;
    const std::uint64_t left =
        std::max(least, limit / part) + task.step_budget / kStepsPerMillisecond;
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(limit, left));
  }

  std::uint32_t most_timeouts(const Task& task) const {
    return endless_.count(task.calls) != 0 ? kMostTimeouts - 1 : kMostTimeouts;
  }

  std::map<std::uint32_t, std::uint32_t> timeouts_;  ///< by family
  std::set<std::uint32_t> used_up_;                  ///< families
  std::set<std::uint32_t> endless_;                  ///< Task::calls of those
  std::set<std::uint32_t> hungry_;                   ///< Task::calls of what ran out of memory
};

}  // namespace meshgrade
