#pragma once

#include <chrono>
#include <map>
#include <string>

#include "grader/batch/batch.h"

namespace meshgrade {

/// Shows how far a batch has come: on a terminal a bar that is written over, with counts and
/// the time left; elsewhere a line for each hand-in.
class BatchProgress {
 public:
  BatchProgress(const Roster& roster, std::size_t count, bool terminal)
      : roster_(roster), count_(count), terminal_(terminal) {}

  /// To stderr.
  void show(const BatchStep& step);
  void finish() const;

  /// "[#####.....] 5/10  3 full, 1 partial, 1 ungradable; 2 min left". `seconds` have passed.
  std::string bar(double seconds) const;
  /// "5/10 alice: 87 of 100 points"
  std::string line(const BatchStep& step) const;

  void count(const BatchStep& step);

  /// How many were graded once more after an error of the grader.
  std::size_t again() const { return again_; }

 private:
  const Roster& roster_;
  std::size_t count_;
  bool terminal_;
  std::size_t done_ = 0;
  std::size_t kept_ = 0;
  std::size_t again_ = 0;
  std::map<std::string, std::size_t> kinds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace meshgrade
