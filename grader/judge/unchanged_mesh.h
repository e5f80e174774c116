#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "grader/judge/finding.h"
#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// What a function must leave as it is, and what to look at where it does not.
struct UnchangedWords {
  const char* meaning;  ///< "the function computes, and leaves the mesh as it was"
  const char* created;  ///< where elements were created or deleted
  const char* moved;    ///< where a vertex lies elsewhere
};

/// What of a mesh is not as it was: numbers of elements, then a vertex that has moved, then the
/// first pointer that has changed.
/// @return nothing if it is the same
std::optional<Finding> find_change(const MeshDump& before, const MeshDump& after,
                                   const std::string& where, const UnchangedWords& words);

/// Adds to what to look at that the mesh had other anchors than after build(), if it had and no
/// cause is named.
void mention_turned_anchors(std::uint32_t turns, CaseJudgement& judgement);

}  // namespace meshgrade
