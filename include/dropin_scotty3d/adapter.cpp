// Lets the grader call the functions of a homework for Scotty3D. Compiled with each such
// submission. Each of the grader's functions makes a Halfedge_Mesh, calls the student's
// function on it, and writes back what it has become.

#include "detail/mesh_bridge.h"
#include "meshedit/poly_mesh.h"

namespace meshedit {
namespace {

template <class Result, class TheirResult, class Argument, class TheirArgument>
std::optional<Handle<Result>> call(
    PolyMesh& mesh, const Handle<Argument>& argument,
    std::optional<TheirResult> (Halfedge_Mesh::*function)(TheirArgument)) {
  Halfedge_Mesh theirs;
  detail::scotty3d::MeshBridge bridge(mesh, theirs);
  const std::optional<TheirResult> returned = (theirs.*function)(bridge.theirs(argument));
  bridge.write_back();
  if (!returned) return std::nullopt;
  return bridge.ours(*returned);
}

}  // namespace

#define SCOTTY3D_FUNCTION(exercise, name, their_name, Result, Argument)     \
  std::optional<Handle<Result>> PolyMesh::name(Handle<Argument> argument) { \
    return call<Result>(*this, argument, &Halfedge_Mesh::their_name);       \
  }
#include "functions.inc"
#undef SCOTTY3D_FUNCTION

}  // namespace meshedit

// Replaced by the student's own definitions when the worker is linked.
#define SCOTTY3D_FUNCTION(exercise, name, their_name, Result, Argument)              \
  [[gnu::weak]] std::optional<Halfedge_Mesh::Result##Ref> Halfedge_Mesh::their_name( \
      Argument##Ref /*element*/) {                                                   \
    meshedit::notImplemented("Halfedge_Mesh::" #their_name);                         \
  }
#include "functions.inc"
#undef SCOTTY3D_FUNCTION
