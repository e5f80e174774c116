// Lets the grader call the functions of a homework for Scotty3D. Compiled with each such
// submission. Each of the grader's functions makes a Halfedge_Mesh, calls the student's
// function on it, and writes back what it has become.

#include <type_traits>

#include "detail/mesh_bridge.h"
#include "meshedit/poly_mesh.h"

namespace {

/// What a function of the homework gives to catmark_subdivide_helper.
struct TakenPositions {
  std::unordered_map<Halfedge_Mesh::VertexCRef, Vec3> vertices;
  std::unordered_map<Halfedge_Mesh::EdgeCRef, Vec3> edges;
  std::unordered_map<Halfedge_Mesh::FaceCRef, Vec3> faces;
};
TakenPositions taken_positions;

}  // namespace

void Halfedge_Mesh::catmark_subdivide_helper(
    const std::unordered_map<VertexCRef, Vec3>& vertex_positions,
    const std::unordered_map<EdgeCRef, Vec3>& edge_vertex_positions,
    const std::unordered_map<FaceCRef, Vec3>& face_vertex_positions) {
  taken_positions = {vertex_positions, edge_vertex_positions, face_vertex_positions};
}

namespace meshedit {
namespace {

using detail::scotty3d::MeshBridge;

template <class Result, class TheirResult, class... TheirArguments, class... Arguments>
std::optional<Handle<Result>> call(
    PolyMesh& mesh, std::optional<TheirResult> (Halfedge_Mesh::*function)(TheirArguments...),
    const Arguments&... arguments) {
  Halfedge_Mesh theirs;
  MeshBridge bridge(mesh, theirs);
  const std::optional<TheirResult> returned = (theirs.*function)(bridge.theirs(arguments)...);
  bridge.write_back();
  if (!returned) return std::nullopt;
  return bridge.ours(*returned);
}

template <class Result>
[[maybe_unused]] Result call_on_mesh(PolyMesh& mesh, Result (Halfedge_Mesh::*function)()) {
  Halfedge_Mesh theirs;
  MeshBridge bridge(mesh, theirs);
  if constexpr (std::is_void<Result>::value) {
    (theirs.*function)();
    bridge.write_back();
  } else {
    const Result result = (theirs.*function)();
    bridge.write_back();
    return result;
  }
}

template <class Taken, class Given>
void give_positions(const MeshBridge& bridge, const Taken& taken, Given& positions) {
  for (const auto& [element, p] : taken)
    positions[bridge.ours(element)] = Vector3D(p.x, p.y, p.z);
}

/// @tparam Positions  of the mesh of the next level, by the elements of this one
/// @param name  of the function: as it is handed out, it gives no positions at all
template <class Positions>
[[maybe_unused]] Positions refine(PolyMesh& mesh, void (Halfedge_Mesh::*function)(),
                                  const char* name) {
  taken_positions = {};
  Halfedge_Mesh theirs;
  MeshBridge bridge(mesh, theirs);
  (theirs.*function)();
  bridge.write_back();
  const detail::StepPause pause;
  const TakenPositions& taken = taken_positions;
  if (taken.vertices.empty() && taken.edges.empty() && taken.faces.empty())
    notImplemented(name);
  Positions positions;
  give_positions(bridge, taken.vertices, positions.vertices);
  give_positions(bridge, taken.edges, positions.edges);
  give_positions(bridge, taken.faces, positions.faces);
  return positions;
}

}  // namespace

#define SCOTTY3D_FUNCTION(exercise, name, their_name, Result, Argument)     \
  std::optional<Handle<Result>> PolyMesh::name(Handle<Argument> argument) { \
    return call<Result>(*this, &Halfedge_Mesh::their_name, argument);       \
  }
#define SCOTTY3D_FUNCTION_OF_TWO(exercise, name, their_name, Result, Argument) \
  std::optional<Handle<Result>> PolyMesh::name(Handle<Argument> first,         \
                                               Handle<Argument> second) {      \
    return call<Result>(*this, &Halfedge_Mesh::their_name, first, second);     \
  }
#define SCOTTY3D_MESH_FUNCTION(exercise, name, their_name, Result) \
  Result PolyMesh::name() {                                        \
    return call_on_mesh(*this, &Halfedge_Mesh::their_name);        \
  }
#define SCOTTY3D_REFINEMENT(exercise, name, their_name)                \
  RefinedPositions PolyMesh::name() {                                  \
    return refine<RefinedPositions>(*this, &Halfedge_Mesh::their_name, \
                                    "Halfedge_Mesh::" #their_name);    \
  }
#include "functions.inc"

}  // namespace meshedit

// Replaced by the student's own definitions when the worker is linked.
#define SCOTTY3D_UNWRITTEN(their_name) \
  { meshedit::notImplemented("Halfedge_Mesh::" #their_name); }
#define SCOTTY3D_FUNCTION(exercise, name, their_name, Result, Argument)              \
  [[gnu::weak]] std::optional<Halfedge_Mesh::Result##Ref> Halfedge_Mesh::their_name( \
      Argument##Ref) SCOTTY3D_UNWRITTEN(their_name)
#define SCOTTY3D_FUNCTION_OF_TWO(exercise, name, their_name, Result, Argument)       \
  [[gnu::weak]] std::optional<Halfedge_Mesh::Result##Ref> Halfedge_Mesh::their_name( \
      Argument##Ref, Argument##Ref) SCOTTY3D_UNWRITTEN(their_name)
#define SCOTTY3D_MESH_FUNCTION(exercise, name, their_name, Result) \
  [[gnu::weak]] Result Halfedge_Mesh::their_name() SCOTTY3D_UNWRITTEN(their_name)
#define SCOTTY3D_REFINEMENT(exercise, name, their_name) \
  [[gnu::weak]] void Halfedge_Mesh::their_name() SCOTTY3D_UNWRITTEN(their_name)
#include "functions.inc"
