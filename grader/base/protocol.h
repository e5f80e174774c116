#pragma once

// What the grader and the worker say to each other. Written for C++17.
//
// The grader gives the worker a file with a TaskList. The worker appends frames to a result
// file: for each task its steps and how it ended. Whatever is in that file was written by a
// process that runs student code: it is a claim, not a fact.

#include <cstdint>
#include <string>
#include <vector>

#include "grader/base/wire.h"

namespace meshgrade {

constexpr std::uint32_t kProtocolVersion = 4;

/// One case for the worker: the exercise, the packed input, and the limits.
struct Task {
  std::string exercise;
  std::string input;
  std::uint64_t step_budget = 0;  ///< uses of handles
  std::uint32_t cpu_ms = 0;       ///< processor time
  std::uint32_t wall_ms = 0;      ///< time on the clock
  std::uint32_t family = 0;  ///< tasks of one family call the same functions: see run_cases
  std::uint32_t calls = 0;   ///< the same in all tasks that call the same functions

  template <class Wire>
  void transfer(Wire& wire) {
    wire(exercise, input, step_budget, cpu_ms, wall_ms, family, calls);
  }
};

struct TaskList {
  std::uint32_t version = kProtocolVersion;
  std::uint64_t memory_bytes = 0;
  std::uint64_t result_bytes = 0;  ///< the most that the result file may hold
  std::uint64_t output_bytes = 0;  ///< the most that one task may print
  bool alone = false;              ///< every task in a process of its own
  std::vector<Task> tasks;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(version, memory_bytes, result_bytes, output_bytes, alone, tasks);
  }
};

/// How a case ended, as far as the worker can tell.
enum class Ending : std::uint32_t {
  kDone = 0,
  kFault = 1,          ///< misuse of a handle, out of steps, or not implemented: see fault_kind
  kSignal = 2,         ///< a crash; `code` is the signal
  kExit = 3,           ///< the code ended the process; `code` is the exit status
  kException = 4,      ///< an exception came out of the student's function
  kOutOfTime = 5,      ///< the time limit
  kOutOfMemory = 6,    ///< the memory limit
  kOutputLimit = 7,    ///< the result file or the student's output grew too large
  kWorkerFailed = 8,   ///< the worker could not do its own part
  kSkipped = 9,        ///< not run: too many of its family before it ran out of time
  kTooManyFiles = 10,  ///< the most files that may be open were open
  kTooManyProcesses = 11,  ///< more processes than are allowed
  kLibraryCheck = 12,  ///< the standard library refused a call; `subject` says which and why
};
constexpr std::uint32_t kLastEnding = static_cast<std::uint32_t>(Ending::kLibraryCheck);

/// The packed result of one completed step of a task.
struct StepFrame {
  std::uint32_t task = 0;
  std::string result;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(task, result);
  }
};

/// How a task ended. Comes after the steps of the task.
struct EndFrame {
  std::uint32_t task = 0;
  Ending ending = Ending::kDone;
  std::uint32_t fault_kind = 0;      ///< a meshedit::FaultKind if ending is kFault
  std::int32_t code = 0;             ///< a signal or an exit status
  std::string subject;               ///< of a fault or check; or the text of an exception
  std::vector<std::uint64_t> stack;  ///< return addresses, innermost first
  std::string interrupted;           ///< packed state at the moment of a fault, or empty
  std::string output;                ///< what the code printed, cut off
  std::uint64_t output_bytes = 0;    ///< how much it printed in all

  template <class Wire>
  void transfer(Wire& wire) {
    wire(task, ending, fault_kind, code, subject, stack, interrupted, output, output_bytes);
  }
};

/// A frame begins with its kind.
enum class FrameKind : std::uint32_t { kStep = 0, kEnd = 1 };

/// After so many tasks of a family that ran out of time the worker gives up on the rest of it;
/// one earlier where it has given up another one that calls the same functions.
constexpr std::uint32_t kMostTimeouts = 3;

/// The most that is kept of what a student's code prints in one case.
constexpr std::size_t kKeptOutputBytes = 4096;

/// The most return addresses that are kept of a call stack.
constexpr std::size_t kMostStackFrames = 64;

/// Address space beyond the memory limit in which the worker says that it was reached.
constexpr std::uint64_t kMemoryToReport = std::uint64_t{256} << 20U;

/// Room in the result file beyond its limit in which the ends of tasks are written down.
constexpr std::uint64_t kRoomForEnds = std::uint64_t{1} << 20U;

/// The worker ends with this when it cannot do its own part, and says on stderr why.
constexpr int kWorkerFailedStatus = 91;

/// File descriptors that the worker is started with.
constexpr int kTaskFile = 3;
constexpr int kResultFile = 4;
constexpr int kOutputFile = 5;

}  // namespace meshgrade
