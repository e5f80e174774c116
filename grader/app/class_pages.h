#pragma once

#include <filesystem>

#include "grader/batch/class_results.h"

namespace meshgrade {

/// Writes the pages of a graded class for the browser: `class.html` in the folder of the batch,
/// and `report.html` beside each report, as its student may see it.
/// @throws UserError if they cannot be written
void write_class_pages(const ClassResults& results, const std::filesystem::path& folder);

}  // namespace meshgrade
