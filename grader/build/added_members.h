#pragma once

#include <string>
#include <vector>

#include "grader/submission/submission.h"

namespace meshgrade {

/// Finds the compiler's complaints about members that a mesh or Bezier class of the course does
/// not have, in a homework for Berkeley's skeleton. Students add such members to the course's
/// own headers, which the grader replaces.
///
/// @param messages  of the compiler (GCC or Clang), without the machine's paths
/// @param headers   the course's headers as they were handed in, to find the line of the member
/// @return a sentence for each such member, with the place of its first use
std::vector<std::string> explain_added_members(const std::string& messages,
                                               const std::vector<SourceFile>& headers);

}  // namespace meshgrade
