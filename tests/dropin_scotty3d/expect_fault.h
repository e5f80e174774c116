#pragma once

#include <optional>

#include "meshedit/fault.h"

namespace meshgrade {

/// The fault that a call raises, if it does.
template <class Call>
std::optional<meshedit::Fault> fault_of(Call call) {
  struct Raised {
    meshedit::Fault fault;
  };
  const auto before = meshedit::detail::fault_handler;
  meshedit::detail::fault_handler = [](const meshedit::Fault& fault) { throw Raised{fault}; };
  std::optional<meshedit::Fault> fault;
  try {
    call();
  } catch (const Raised& raised) {
    fault = raised.fault;
  }
  meshedit::detail::fault_handler = before;
  return fault;
}

}  // namespace meshgrade
