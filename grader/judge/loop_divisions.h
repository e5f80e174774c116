#pragma once

#include <vector>

#include "grader/judge/loop_misconceptions.h"

namespace meshgrade {

/// Which of the weights of Loop subdivision were divided as whole numbers ("3 / 8" is 0 in
/// C++), if that explains all of `actual`, to `allowed`, a length: the fewest that do. At most
/// one misconception, whose advice names the weights; "integer-weight" if only the weights of
/// old vertices inside are among them, otherwise "integer-division".
Misconceptions recognize_divisions(const RefinedStep& step, const std::vector<Point3>& actual,
                                   double allowed);

}  // namespace meshgrade
