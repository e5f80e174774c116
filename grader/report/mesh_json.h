#pragma once

// Meshes as JSON for the viewer's page, in flat lists of numbers.

#include <nlohmann/json.hpp>

#include "grader/judge/mesh_scene.h"
#include "grader/mesh/mesh_changes.h"
#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/mesh_rules.h"

namespace meshgrade {

/// `h`: next, twin, vertex, edge, face and live of each half-edge; `v`: halfedge and live of
/// each vertex, `p` its x, y and z (null if it is no finite number); `e`: halfedge and live of
/// each edge; `f` and `b`: halfedge, live and is_boundary of each face and boundary loop.
/// Pointers are the numbers of MeshDump.
nlohmann::ordered_json to_json_value(const MeshDump& mesh);

/// `element`, `pointer`, `before`, `after`.
nlohmann::ordered_json to_json_value(const std::vector<PointerChange>& changes);

/// `rule`, `meaning`, `element`, `expected`, `actual`, `look_at`.
nlohmann::ordered_json to_json_value(const std::vector<RuleBreak>& breaks);

/// `step`, `edge`, the meshes `before`, `yours`, `expected`, and what can be said of them:
/// `broken` rules of yours, and `changes` from before.
nlohmann::ordered_json to_json_value(const MeshScene& scene);

}  // namespace meshgrade
