#pragma once

#include <string>
#include <vector>

#include "grader/mutants/source_code.h"

namespace meshgrade {

/// One replacement in a text.
struct Edit {
  std::size_t at = 0;
  std::size_t size = 0;
  std::string text;

  /// What goes in front of the first statement of the function; mostly nothing.
  std::string prelude = "";
  std::size_t prelude_at = 0;  ///< before `at`
};

/// A kind of mistake: finds every place of a solution where it can be made.
struct MutationOperator {
  const char* name;
  const char* description;
  std::vector<Edit> (*edits)(const SourceCode& code);
};

const std::vector<MutationOperator>& mutation_operators();

}  // namespace meshgrade
