#pragma once

#include <filesystem>

#include "grader/batch/class_results.h"

namespace meshgrade {

/// The page beside a student's report.
inline constexpr const char* kStudentPage = "report.html";

/// Writes the pages of a graded class for the browser: `class.html` in the folder of the batch,
/// and beside each report that has none yet, the page of what its student may see.
/// @throws UserError if they cannot be written
void write_class_pages(const ClassResults& results, const std::filesystem::path& folder);

}  // namespace meshgrade
