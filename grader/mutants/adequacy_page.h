#pragma once

#include <string>

#include "grader/mutants/adequacy.h"

namespace meshgrade {

/// docs/adequacy.md: the kill table, the survivors, where the findings point, right answers.
std::string to_markdown(const Adequacy& adequacy);

/// The same in a few lines for a terminal, with all that is not as it should be.
std::string to_summary(const Adequacy& adequacy);

}  // namespace meshgrade
