#pragma once

// What must hold for all that splits, flips and collapses make of a mesh of triangles.

#include <optional>
#include <string>
#include <utility>

#include "grader/judge/finding.h"
#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// The first face that is no triangle, as a finding; nothing if there is none.
/// @param mesh  keeps all mesh rules
std::optional<Finding> find_other_face(const MeshDump& mesh, const std::string& look_at);

/// "1 part, 0 boundary loops, V - E + F = 2": the same for surfaces of the same topology.
/// @param mesh  keeps all mesh rules
std::string topology_text(const MeshDump& mesh);

/// An edge by the vertices that it joins: "v3-v5".
std::string edge_text(const std::pair<Ref, Ref>& ends);

}  // namespace meshgrade
