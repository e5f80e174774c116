#pragma once

#include <vector>

#include "grader/judge/finding.h"

namespace meshgrade {

/// Some cases cannot tell two misconceptions apart: at t = 1/2, t and 1 - t are the same. Where
/// several are named, keeps those that another case of the same exercise names alone; all of
/// them if there is no such case.
void tell_apart(const std::vector<CaseJudgement*>& judgements);

}  // namespace meshgrade
