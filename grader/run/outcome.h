#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grader/base/protocol.h"

namespace meshgrade {

/// A place in the code, innermost first in a stack.
struct StackFrame {
  std::string function;
  std::string file;  ///< as the compiler was given it; empty if not known
  int line = 0;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(function, file, line);
  }
};

/// What came of a case: a claim of the worker, well-formed but not judged.
struct Outcome {
  Ending ending = Ending::kDone;
  std::uint32_t fault_kind = 0;  ///< a meshedit::FaultKind if ending is kFault
  std::int32_t code = 0;         ///< a signal or an exit status
  std::string subject;
  std::vector<std::string> steps;  ///< packed results of the completed steps
  std::string interrupted;         ///< packed state at the moment of a fault
  std::vector<StackFrame> stack;   ///< the student's own frames only
  std::string output;              ///< what the code printed, cut off
  std::uint64_t output_bytes = 0;
  /// Nothing came of this case, since one of those that were run with it spoiled them all.
  bool lost = false;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(ending, fault_kind, code, subject, steps, interrupted, stack, output, output_bytes,
         lost);
  }
};

}  // namespace meshgrade
