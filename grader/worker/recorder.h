#pragma once

// Writes down what the student's code does, so that it is not lost when that code crashes.

#include <functional>
#include <string>

#include "grader/base/protocol.h"

namespace meshgrade {

/// The steps of the task that is running. One object, owned by the worker's main loop; the
/// viewer's task has another one for each function that it calls.
class Recorder {
 public:
  Recorder() = default;

  /// Gives packed steps to somebody else, and not to the result file.
  explicit Recorder(std::function<void(std::string)> receiver)
      : receiver_(std::move(receiver)) {}

  /// Adds the packed result of a completed step to the result file.
  template <class T>
  void add_step(const T& value) {
    if (receiver_) return receiver_(to_wire(value));
    write_step(to_wire(value));
  }

  /// Tells how to pack the state should the student's code be stopped by a fault from now on.
  void set_state_source(std::function<std::string()> source) { state_ = std::move(source); }

  /// The packed state, or nothing.
  std::string interrupted_state() const { return state_ ? state_() : std::string(); }

 private:
  void write_step(const std::string& bytes);

  std::function<std::string()> state_;
  std::function<void(std::string)> receiver_;
};

}  // namespace meshgrade
