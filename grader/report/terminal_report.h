#pragma once

#include <functional>
#include <string>

#include "grader/report/report.h"

namespace meshgrade {

struct TerminalStyle {
  bool color = false;
  bool verbose = false;  ///< every finding of every case, and what the code printed
  /// What shows all, where something is left out for lack of room.
  std::string all_shown_by = "--verbose shows all";
  std::string figures = {};  ///< the folder that pictures were written to
  /// The command that runs a case again; if it is empty, none is shown.
  std::function<std::string(const std::string& case_id)> again = {};
};

/// The report as text for a terminal: a table, then for each exercise that lost points, be it
/// of extra credit, its first and simplest failure.
std::string to_terminal(const Report& report, const TerminalStyle& style);

/// Only the files that do not compile, and the cases, without points.
std::string cases_to_terminal(const Report& report, const TerminalStyle& style);

/// The simplest case that was not passed: required groups come before extra credit, and cases
/// with a finding before those without. nullptr if there is none.
const CaseReport* first_failure(const ExerciseReport& exercise);

}  // namespace meshgrade
