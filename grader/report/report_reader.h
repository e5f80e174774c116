#pragma once

#include <string>

#include "grader/report/report.h"

namespace meshgrade {

/// The Report that to_json() has written: to_json() of it gives the same bytes.
/// @throws UserError that says what is wrong with the text
Report read_report(const std::string& json);

}  // namespace meshgrade
