#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace meshgrade {

/// One kind of work of a command.
struct Stage {
  std::string name;
  std::size_t count = 0;      ///< how often it was done
  double milliseconds = 0.0;  ///< on the clock, all times together
};

/// How long the stages of a command take. May be told by several threads at a time; what runs
/// side by side counts twice.
class StageTimes {
 public:
  void add(const std::string& name, double milliseconds);

  /// In the order in which they ended first.
  std::vector<Stage> stages() const;

 private:
  mutable std::mutex mutex_;
  std::vector<Stage> stages_;
};

/// Measures from here to the end of its scope. Without a place to keep it, does nothing.
class StageTimer {
 public:
  StageTimer(StageTimes* times, const char* name)
      : times_(times), name_(name), begin_(std::chrono::steady_clock::now()) {}
  ~StageTimer();
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  StageTimes* times_;
  const char* name_;
  std::chrono::steady_clock::time_point begin_;
};

/// A table with a line for each stage.
std::string to_table(const std::vector<Stage>& stages, double all_milliseconds);

}  // namespace meshgrade
