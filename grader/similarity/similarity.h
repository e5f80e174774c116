#pragma once

#include <string>
#include <vector>

#include "grader/roster/roster.h"
#include "grader/similarity/shared_code.h"

namespace meshgrade {

struct SimilarityOptions {
  SubmissionRules rules;
  std::size_t least_tokens = 36;  ///< a shorter run, of some five lines, is chance
};

/// Reads the sources of all hand-ins, for a comparison of each with each other. The skeleton
/// does not count, nor do the files that Berkeley's course hands out. Hand-ins that cannot be
/// read are noted and left out.
SharedCode read_for_comparison(const Roster& roster, const Submission& skeleton,
                               const SimilarityOptions& options,
                               std::vector<std::string>& notes);

/// The text with blanks in place of the lines that stand in the skeleton, whatever the space
/// around them.
std::string without_skeleton(std::string text, const Submission& skeleton);

}  // namespace meshgrade
