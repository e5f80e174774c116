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

/// Who handed in code that is like another's: `similar.html` in the folder of the batch shows
/// it side by side.
struct SimilarHandIns {
  std::vector<std::vector<std::string>> groups;  ///< keys of hand-ins, most alike first
  std::size_t pairs = 0;                         ///< that have anything in common
};

/// Compares all hand-ins of a class with each other, and writes the page of that.
/// @throws UserError if it cannot be written
SimilarHandIns write_similar_page(const Roster& roster, const Assignment& assignment,
                                  const std::filesystem::path& folder);

/// Writes the pages of a graded class for the browser: `class.html` in the folder of the batch,
/// and beside each report that has none yet, the page of what its student may see.
/// @throws UserError if they cannot be written
void write_class_pages(const ClassResults& results, const SimilarHandIns& similar,
                       const std::filesystem::path& folder);

}  // namespace meshgrade
