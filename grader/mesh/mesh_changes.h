#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// A pointer that differs between two states of a mesh.
struct PointerChange {
  std::string element;  ///< "h12"
  std::string pointer;  ///< "next"
  std::string before;   ///< "h3", "unset"; empty for an element that is new
  std::string after;    ///< empty for an element that was deleted
};

/// Every pointer that an operation changed: half-edges, vertices, edges, faces, boundary loops,
/// each by number. Elements are told by their numbers, which they keep for life.
///
/// @param most  where to stop
std::vector<PointerChange> find_changes(
    const MeshDump& before, const MeshDump& after,
    std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace meshgrade
