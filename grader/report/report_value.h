#pragma once

// The report as a JSON value, for renderings that put more around it.

#include <nlohmann/json.hpp>

#include "grader/report/report.h"

namespace meshgrade {

/// What to_json() writes.
nlohmann::ordered_json to_json_value(const Report& report);

/// A case of it.
nlohmann::ordered_json to_json_value(const CaseReport& report);

}  // namespace meshgrade
