#pragma once

// Calls functions of a homework on one of our meshes.

#include <optional>

#include "mesh_bridge.h"
#include "meshedit/poly_mesh.h"

namespace meshedit {
namespace detail {
namespace scotty3d {

/// Calls a function about one element, or two.
/// @tparam Access  of the year: see mesh_access.h
/// @return ours for what it returned
template <class Access, class Result, class Theirs, class TheirResult, class... TheirArguments,
          class... Arguments>
std::optional<Handle<Result>> call(
    PolyMesh& mesh, std::optional<TheirResult> (Theirs::*function)(TheirArguments...),
    const Arguments&... arguments) {
  Theirs theirs;
  MeshBridge<Access> bridge(mesh, theirs);
  const std::optional<TheirResult> returned = (theirs.*function)(bridge.theirs(arguments)...);
  Access::finish(theirs);
  bridge.write_back();
  if (!returned) return std::nullopt;
  return bridge.ours(*returned);
}

/// Calls a function about the whole mesh that returns nothing.
template <class Access, class Theirs>
void call_on_mesh(PolyMesh& mesh, void (Theirs::*function)()) {
  Theirs theirs;
  MeshBridge<Access> bridge(mesh, theirs);
  (theirs.*function)();
  Access::finish(theirs);
  bridge.write_back();
}

}  // namespace scotty3d
}  // namespace detail
}  // namespace meshedit
