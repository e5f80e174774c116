#pragma once

#include <string>

#include "grader/report/report.h"

namespace meshgrade {

/// The report as JSON by the schema of docs/report.schema.json. The same report gives the same
/// bytes.
std::string to_json(const Report& report);

}  // namespace meshgrade
