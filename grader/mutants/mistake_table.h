#pragma once

// What students are told about mistakes that students really make: the submissions of
// tests/submissions/wrong, each with one mistake.

#include <filesystem>
#include <string>
#include <vector>

#include "grader/mutants/mutant_grading.h"

namespace meshgrade {

/// A submission with one mistake, and the first thing that is said about it.
struct KnownMistake {
  std::string exercise;
  std::string mistake;  ///< in the words of its first line, "// Wrong: ..."
  std::string rule;     ///< of the first finding; the verdict if there is none
  std::string told;     ///< what it probably comes from, or else what to look at
};

/// Grades the folders exercise/mistake under `wrong`, `jobs` at a time; `reference` has the
/// files that they do not hold.
/// @throws UserError if a folder cannot be read
std::vector<KnownMistake> grade_known_mistakes(const Assignment& assignment,
                                               const std::filesystem::path& wrong,
                                               const Submission& reference,
                                               const GradeFunction& grade, unsigned jobs,
                                               const JobProgress& progress);

/// The section of docs/adequacy.md about them, with its heading.
std::string to_markdown(const std::vector<KnownMistake>& mistakes);

/// The page with this section in place of the one that it has, at its end.
std::string with_mistakes(const std::string& page, const std::vector<KnownMistake>& mistakes);

}  // namespace meshgrade
