#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "meshedit/meshedit.h"

namespace meshedit {

inline std::string to_string(const Fault& fault) {
  return std::string(fault.subject) + " " + describe(fault.kind);
}

/// Turns faults into exceptions while it lives, and gives the step budget back afterwards.
class FaultTest : public testing::Test {
 protected:
  FaultTest() {
    detail::fault_handler = [](const Fault& fault) { throw Fault(fault); };
  }
  ~FaultTest() override {
    detail::fault_handler = old_handler_;
    detail::steps_left = INT64_MAX;
  }

  /// The fault that `action` meets, as a sentence; empty if there is none.
  template <class Action>
  static std::string fault_of(Action action) {
    try {
      action();
    } catch (const Fault& fault) {
      return to_string(fault);
    }
    return "";
  }

  static std::string sentence(FaultKind kind, const char* subject) {
    return to_string(Fault{kind, subject});
  }

 private:
  detail::FaultHandler old_handler_ = detail::fault_handler;
};

}  // namespace meshedit
