#pragma once

// Each format has a file of its own beside this one; exports.cpp lists them. What they have to
// follow is said at the top of each file.

#include "grader/exports/exports.h"

namespace meshgrade {

/// The number of a text with a decimal point or comma; not a number for any other text.
double gradebook_number(std::string text);

Exported write_csv(const ClassResults& results, const ExportOptions& options);
Exported write_canvas(const ClassResults& results, const ExportOptions& options);
Exported write_moodle(const ClassResults& results, const ExportOptions& options);

std::string write_gradescope(const StudentResult& result, const ExportOptions& options);
std::string write_autolab(const StudentResult& result, const ExportOptions& options);
std::string write_prairielearn(const StudentResult& result, const ExportOptions& options);
std::string write_github_annotations(const StudentResult& result, const ExportOptions& options);
std::string write_github_result(const StudentResult& result, const ExportOptions& options);
std::string write_junit(const StudentResult& result, const ExportOptions& options);
std::string write_markdown(const StudentResult& result, const ExportOptions& options);

}  // namespace meshgrade
