#pragma once

#include "grader/cases/operation_cases.h"

namespace meshgrade {

/// Adds what may be left of a sequence of flips and splits that went wrong: fewer of its
/// operations on the same mesh, then as many on smaller meshes. All are operations with a
/// single right outcome. Adds nothing for a single operation that the cases ask for anyway.
void add_smaller_operations(CaseMaker& maker, const Case& failed);

}  // namespace meshgrade
