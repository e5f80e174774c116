#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/cases/case.h"
#include "grader/run/outcome.h"

namespace meshgrade {

/// A right solution of an exercise, run.
struct RightRun {
  std::string solution;
  std::vector<Case> cases;
  std::vector<Outcome> outcomes;  ///< one for each case
};

/// What the judge says where a right solution's mesh is spoiled in one pointer.
struct SinglePointers {
  std::string solution;
  std::string exercise;
  std::size_t tried = 0;      ///< pointers that were changed, and so that it is a mistake
  std::size_t alone = 0;      ///< of these, listed as the only wrong one
  std::size_t first = 0;      ///< of these, the first that is listed
  double milliseconds = 0.0;  ///< in which 99 % of them are judged
};

/// Takes the meshes that a right flip or split leaves behind, in all cases of one operation,
/// and changes one pointer in each, several times: a pointer of an element that the operation
/// has changed or made, to any other element of its kind or to none. What is as right as
/// before, such as another anchor, does not count.
SinglePointers judge_single_pointers(const ExerciseRubric& rubric, const RightRun& run,
                                     double tolerance, std::uint64_t seed);

}  // namespace meshgrade
