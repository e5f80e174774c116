#pragma once

#include "grader/cases/case_list.h"
#include "grader/operations/local_operation.h"

namespace meshgrade {

/// Adds the cases of an exercise that is about one operation: every element of the meshes of
/// polygons, by what is right for it, in the groups
///
///   basic     what has one right answer, inside of the surface
///   boundary  the same, at a boundary
///   refused   what leaves no surface, or a degenerate one
///   stress    other anchors, one operation after the other, and a large mesh on which only the
///             faces around the element may be looked at
void make_local_operation_cases(CaseMaker& maker, const LocalOperation& operation);

}  // namespace meshgrade
