#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/batch/class_results.h"
#include "grader/roster/roster.h"

namespace meshgrade {

/// The page beside a student's report.
inline constexpr const char* kStudentPage = "report.html";

/// Keys of hand-ins that are alike.
using SimilarGroups = std::vector<std::vector<std::string>>;

/// Compares all hand-ins of a class with each other, and writes the page of that:
/// `similar.html` in the folder of the batch.
/// @throws UserError if it cannot be written
SimilarGroups write_similar_page(const Roster& roster, const Assignment& assignment,
                                 const std::filesystem::path& folder);

/// Writes the pages of a graded class for the browser: `class.html` in the folder of the batch,
/// and beside each report that has none yet, the page of what its student may see.
/// @throws UserError if they cannot be written
void write_class_pages(const ClassResults& results, const SimilarGroups& similar,
                       const std::filesystem::path& folder);

}  // namespace meshgrade
