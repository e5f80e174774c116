#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "grader/view/mesh_session.h"

namespace meshgrade {

/// What the page shows of a session: `submission`, `mesh`, `verbs`, `build`, `timeline`,
/// `position`, the `state` that is looked at with the mesh `before` and, if it is wrong,
/// `expected`, and what `stopped`. docs/viewer.md explains the keys.
nlohmann::ordered_json to_json_value(const MeshSession& session);

/// The same, with meshes as `write_mesh` gives them.
nlohmann::ordered_json to_json_value(
    const MeshSession& session,
    const std::function<nlohmann::ordered_json(const MeshDump&)>& write_mesh);

/// The state after so many operations, as in `state`.
nlohmann::ordered_json state_value(const MeshSession& session, std::size_t position);

/// `label` and `state` of each level of subdivision.
nlohmann::ordered_json levels_value(const MeshSession& session);

/// `normals`: x, y and z for each vertex, null where it is none, or why there are none,
/// `error`.
nlohmann::ordered_json to_json_value(const MeshSession::Normals& normals, const MeshDump& mesh);

}  // namespace meshgrade
