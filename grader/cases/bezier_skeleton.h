#pragma once

#include <string>
#include <vector>

#include "grader/assignment/assignment.h"

namespace meshgrade {

/// What a skeleton promises about curves and patches, and so what may be asked.
enum class BezierSkeleton {
  kMeshedit,    ///< ours: curves of any number of points, nets of any size
  kCourse2017,  ///< Berkeley's: curves of 4 points, nets of 4 x 4; evaluate1D takes 4 points,
                ///< and a patch has no evaluateStep
  kCourse2020,  ///< Berkeley's: the same with evaluateStep, for the 4, 3 or 2 points of a level
};

/// The option of the exercise that names it, and its values, in the order above.
constexpr const char* kSkeletonOption = "skeleton";
inline std::vector<std::string> skeleton_choices() {
  return {"meshedit", "berkeley-2017", "berkeley-2020"};
}

/// The one that the rubric names; ours if it names none.
inline BezierSkeleton bezier_skeleton(const ExerciseRubric& rubric) {
  const auto found = rubric.options.find(kSkeletonOption);
  const std::string name = found == rubric.options.end() ? "" : found->second.value;
  if (name == skeleton_choices()[1]) return BezierSkeleton::kCourse2017;
  if (name == skeleton_choices()[2]) return BezierSkeleton::kCourse2020;
  return BezierSkeleton::kMeshedit;
}

}  // namespace meshgrade
