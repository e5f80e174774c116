#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grader/similarity/shared_code.h"

namespace meshgrade {

/// Pairs from this share on make a group.
constexpr int kGroupPercent = 50;

/// A page for a browser that needs nothing else: the groups, all pairs, and for the first
/// `shown` pairs both sources with what they share marked.
std::string similarity_page(const SharedCode& code, const std::vector<SimilarPair>& pairs,
                            std::size_t shown);

}  // namespace meshgrade
