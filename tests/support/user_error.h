#pragma once

#include <string>

#include "grader/base/errors.h"

namespace meshgrade {

/// The message of the UserError that a call throws; empty if it throws none.
template <class Call>
std::string user_error(Call call) {
  try {
    call();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

}  // namespace meshgrade
