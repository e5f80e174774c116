#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "grader/judge/finding.h"
#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// What of a mesh is not as it was, for a function that must not change it: numbers of
/// elements, then a vertex that has moved, then the first pointer that has changed.
/// @return nothing if it is the same
std::optional<Finding> find_change(const MeshDump& before, const MeshDump& after,
                                   const std::string& where);

/// Adds to what to look at that the mesh had other anchors than after build(), if it had and no
/// cause is named.
void mention_turned_anchors(std::uint32_t turns, CaseJudgement& judgement);

}  // namespace meshgrade
