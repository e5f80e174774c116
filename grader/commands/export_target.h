#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/commands/output_check.h"
#include "grader/exports/exports.h"

namespace meshgrade {

/// A file to write the result of one submission to, and in which form.
struct ExportTarget {
  const StudentExport* format = nullptr;
  std::filesystem::path file;  ///< "-": standard output
};

/// From texts like "gradescope=results.json".
/// @throws UserError if one is of another form, or names no format
std::vector<ExportTarget> parse_export_targets(const std::vector<std::string>& texts);

/// As they were named, to be checked.
std::vector<Output> outputs_of(const std::vector<ExportTarget>& targets);

/// Writes the result in all these forms; of hidden cases only what students may see.
/// @throws UserError if a file cannot be written
void write_exports(const std::vector<ExportTarget>& targets, const Report& report);

/// The same for a submission that cannot be graded, or where the grader fails.
void write_exports(const std::vector<ExportTarget>& targets, ResultStatus status,
                   const std::string& reason);

/// "2026-01-31T12:00:00", in UTC: now.
std::string time_of_export();

}  // namespace meshgrade
