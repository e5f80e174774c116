#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grader/submission/submission.h"

namespace meshgrade {

/// Which files could have a part in what these functions do: those that name them, those that
/// give names to what is in any of these, and those that could act without being called. A file
/// of which that cannot be told has a part in everything.
/// @param functions  "HalfedgeMesh::flipEdge"; only the last name counts
/// @return           places in `sources`, in order
std::vector<std::size_t> files_reached(const std::vector<SourceFile>& sources,
                                       const std::vector<std::string>& functions);

}  // namespace meshgrade
