#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grader/submission/submission.h"

namespace meshgrade {

/// Sources that mean the same whether each is compiled on its own or all of them one after the
/// other as one, which takes less than half of the time: as their places in `sources`, in
/// order. Empty if there are no two of them.
///
/// A file is left out when anything of it could be seen by another one: a macro, an overload or
/// any other name that the other one mentions, a using directive or a header of the standard
/// library that the others do not have as well. What cannot be told for sure is left out, too.
/// @param headers  those that were handed in: a source that includes one is left out
std::vector<std::size_t> joinable(const std::vector<SourceFile>& sources,
                                  const std::vector<SourceFile>& headers);

/// Shares `joined` out to at most `units` parts of as many files, in order.
std::vector<std::vector<std::size_t>> share_out(const std::vector<std::size_t>& joined,
                                                std::size_t units);

/// A source that is all of these, one after the other.
/// @param names  of files in the folder where it is compiled
std::string joined_source(const std::vector<std::string>& names);

}  // namespace meshgrade
