#pragma once

#include <string>
#include <vector>

#include "grader/roster/roster.h"

namespace meshgrade {

/// Two hand-ins that have text in common: so many percent of the one's are in the other.
struct SimilarPair {
  std::string first;
  std::string second;
  int of_first = 0;
  int of_second = 0;

  int most() const { return of_first > of_second ? of_first : of_second; }
};

struct SimilarityOptions {
  SubmissionRules rules;
  unsigned least_tokens = 24;  ///< a shorter run of equal tokens is chance
  int least_percent = 1;
};

/// Compares the sources of all hand-ins with each other, without the lines that are the
/// skeleton's, by Debian's similarity-tester (sim_c++), which looks at tokens: names, layout
/// and comments do not matter. Hand-ins that cannot be read are noted.
/// @return the pairs with something in common, the most similar first
/// @throws UserError if the tool is not installed
std::vector<SimilarPair> find_similar(const Roster& roster, const Submission& skeleton,
                                      const SimilarityOptions& options,
                                      std::vector<std::string>& notes);

/// The text without the lines that stand in the skeleton, whatever the space around them.
std::string without_skeleton(const std::string& text, const Submission& skeleton);

}  // namespace meshgrade
