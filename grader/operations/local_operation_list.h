#pragma once

#include <string>

#include "grader/operations/local_operation.h"

namespace meshgrade {

/// The operation that an exercise is about; nullptr if it is not about one.
const LocalOperation* find_local_operation(const std::string& exercise);

}  // namespace meshgrade
