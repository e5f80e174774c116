#pragma once

#include <string>

#include "grader/report/report.h"

namespace meshgrade {

struct TerminalStyle {
  bool color = false;
  bool verbose = false;  ///< every finding of every case, and what the code printed
};

/// The report as text for a terminal: a table, then for each exercise that lost points its
/// first and simplest failure.
std::string to_terminal(const Report& report, const TerminalStyle& style);

}  // namespace meshgrade
