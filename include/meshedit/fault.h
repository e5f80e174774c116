#pragma once

// What happens when a mesh is used in a way that has no meaning: a handle that was never set,
// a walk that never ends, a function that is not written yet. You do not need anything from
// this file to do the exercises, except `notImplemented`, which the stubs call.

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace meshedit {

/// The ways in which a mesh can be misused.
enum class FaultKind : std::uint32_t {
  kUnsetHandle = 1,     ///< the handle was never given an element
  kDeletedHandle = 2,   ///< its element was deleted from the mesh
  kPastEndHandle = 3,   ///< it is the `end()` of a list, not an element
  kForeignHandle = 4,   ///< its element belongs to another mesh
  kOutOfSteps = 5,      ///< the step budget is used up: the walk does not end
  kNotImplemented = 6,  ///< a stub that nobody has filled in yet
  // Only in homework for other skeletons:
  kEndReference = 7,     ///< it is `end()`, which pointers of new elements are there as well
  kFailedAssertion = 8,  ///< an assertion of the code's own does not hold
};

/// One misuse. `subject` says of what: "vertex handle", or the name of a function.
struct Fault {
  FaultKind kind;
  const char* subject;
};

/// A sentence about a fault, without its subject.
inline const char* describe(FaultKind kind) {
  switch (kind) {
    case FaultKind::kUnsetHandle:
      return "was never set: it points to no element";
    case FaultKind::kDeletedHandle:
      return "points to an element that was deleted";
    case FaultKind::kPastEndHandle:
      return "is past the end of the list: it points to no element";
    case FaultKind::kForeignHandle:
      return "points to an element of another mesh";
    case FaultKind::kOutOfSteps:
      return "walked too many steps: a loop over the mesh does not end";
    case FaultKind::kNotImplemented:
      return "is not implemented yet";
    case FaultKind::kEndReference:
      return "is end(): it leads to no element";
    case FaultKind::kFailedAssertion:
      return "does not hold";
  }
  return "is misused";
}

namespace detail {

/// Receives every fault and must not return. The grader installs its own; a program that
/// installs none prints the fault and aborts, so that a debugger stops in your function.
using FaultHandler = void (*)(const Fault&);

[[noreturn]] inline void print_and_abort(const Fault& fault) {
  std::fprintf(stderr, "meshedit: %s %s\n", fault.subject, describe(fault.kind));
  std::abort();
}

inline FaultHandler fault_handler = [](const Fault& fault) { print_and_abort(fault); };

/// Steps that may still be taken. Every use of a handle is one step.
inline std::int64_t steps_left = INT64_MAX;

[[noreturn, gnu::noinline, gnu::cold]] inline void raise_fault(FaultKind kind,
                                                               const char* subject) {
  const Fault fault{kind, subject};
  fault_handler(fault);
  print_and_abort(fault);
}

/// Counts one step. Compiled out, like all checks, by MESHEDIT_UNCHECKED.
inline void count_step(const char* subject) {
#ifndef MESHEDIT_UNCHECKED
  if (--steps_left < 0) raise_fault(FaultKind::kOutOfSteps, subject);
#else
  (void)subject;
#endif
}

/// Stops the counting while it lives: the mesh's own work is not a student's step.
class StepPause {
 public:
  StepPause() : saved_(steps_left) { steps_left = INT64_MAX; }
  StepPause(const StepPause&) = delete;
  StepPause& operator=(const StepPause&) = delete;
  ~StepPause() { steps_left = saved_; }

 private:
  std::int64_t saved_;
};

}  // namespace detail

/// Marks a function that is not written yet. Delete the call when you start to write.
[[noreturn]] inline void notImplemented(const char* function) {
  detail::raise_fault(FaultKind::kNotImplemented, function);
}

}  // namespace meshedit
