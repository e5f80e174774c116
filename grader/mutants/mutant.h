#pragma once

#include <string>
#include <vector>

#include "grader/submission/submission.h"

namespace meshgrade {

/// A right solution that mutants are made of: "reference" or "textbook".
struct Original {
  std::string name;
  Submission submission;
};

/// A solution with one mistake.
struct Mutant {
  std::string original;  ///< Original::name
  std::string file;      ///< "edge_flip.cpp"
  std::string exercise;  ///< "edge_flip"
  std::string operator_name;
  std::string function;  ///< in which the mistake is
  std::size_t line = 0;  ///< from 1
  std::string was;       ///< the lines concerned, as one line
  std::string becomes;
  std::size_t repetition = 0;  ///< how many mutants before this one read the same
  std::string text;            ///< of the whole file
  /// The id of the mutant that has the same mistake always, if this one has it only sometimes.
  std::string always;

  /// "textbook/edge_flip.cpp: other-variable: <was> => <becomes>": the same as long as the line
  /// is the same, wherever it is.
  std::string id() const;
};

/// All mutants of a file, each different from all others.
std::vector<Mutant> make_mutants(const Original& original, const SourceFile& file);

}  // namespace meshgrade
