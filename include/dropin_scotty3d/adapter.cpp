// Lets the grader call the functions of a homework for Scotty3D. Compiled with each such
// submission. Each of the grader's functions makes a Halfedge_Mesh, calls the student's
// function on it, and writes back what it has become.

#include <type_traits>

#include "detail/calls.h"
#include "mesh_access.h"

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

using detail::scotty3d::MeshAccess;
using MeshBridge = detail::scotty3d::MeshBridge<MeshAccess>;

/// Whether the vertices are the same, in the same places.
bool same_vertices(const Halfedge_Mesh& a, const Halfedge_Mesh& b) {
  const detail::StepPause pause;
  return std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                    [](const auto& v, const auto& w) { return v.position == w.position; });
}

void call_on_mesh(PolyMesh& mesh, void (Halfedge_Mesh::*function)(), const char* /*name*/) {
  detail::scotty3d::call_on_mesh<MeshAccess>(mesh, function);
}

/// @param name  of the function: as it is handed out, it says that it is done and does nothing
bool call_on_mesh(PolyMesh& mesh, bool (Halfedge_Mesh::*function)(), const char* name) {
  Halfedge_Mesh theirs;
  MeshBridge bridge(mesh, theirs);
  const Halfedge_Mesh before = theirs;
  const bool done = (theirs.*function)();
  if (done && same_vertices(before, theirs)) notImplemented(name);
  bridge.write_back();
  return done;
}

/// Whether a function makes nothing at all of an octahedron, of which it must make something.
template <class Argument>
bool is_unwritten(bool (Halfedge_Mesh::*function)(Argument), Argument argument) {
  PolyMesh octahedron;
  octahedron.build(
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  Halfedge_Mesh theirs;
  const MeshBridge bridge(octahedron, theirs);
  const Halfedge_Mesh before = theirs;
  return !(theirs.*function)(argument) && same_vertices(before, theirs);
}

/// @param name  of the function: as it is handed out, it gives up at once
template <class Argument>
bool call_with(PolyMesh& mesh, bool (Halfedge_Mesh::*function)(Argument), Argument argument,
               const char* name) {
  Halfedge_Mesh theirs;
  MeshBridge bridge(mesh, theirs);
  const Halfedge_Mesh before = theirs;
  const bool done = (theirs.*function)(argument);
  if (!done && same_vertices(before, theirs) && is_unwritten(function, Argument(0.5)))
    notImplemented(name);
  bridge.write_back();
  return done;
}

template <class Taken, class Given>
void give_positions(const MeshBridge& bridge, const Taken& taken, Given& positions) {
  for (const auto& [element, p] : taken)
    positions[bridge.ours(element)] = Vector3D(p.x, p.y, p.z);
}

/// @param name  of the function: as it is handed out, it gives no positions at all
RefinedPositions refine(PolyMesh& mesh, void (Halfedge_Mesh::*function)(), const char* name) {
  taken_positions = {};
  Halfedge_Mesh theirs;
  MeshBridge bridge(mesh, theirs);
  (theirs.*function)();
  bridge.write_back();
  const detail::StepPause pause;
  const TakenPositions& taken = taken_positions;
  if (taken.vertices.empty() && taken.edges.empty() && taken.faces.empty())
    notImplemented(name);
  RefinedPositions positions;
  give_positions(bridge, taken.vertices, positions.vertices);
  give_positions(bridge, taken.edges, positions.edges);
  give_positions(bridge, taken.faces, positions.faces);
  return positions;
}

}  // namespace

#define SCOTTY3D_FUNCTION(exercise, name, their_name, Result, Argument)                  \
  std::optional<Handle<Result>> PolyMesh::name(Handle<Argument> argument) {              \
    return detail::scotty3d::call<MeshAccess, Result>(*this, &Halfedge_Mesh::their_name, \
                                                      argument);                         \
  }
#define SCOTTY3D_FUNCTION_OF_TWO(exercise, name, their_name, Result, Argument)           \
  std::optional<Handle<Result>> PolyMesh::name(Handle<Argument> first,                   \
                                               Handle<Argument> second) {                \
    return detail::scotty3d::call<MeshAccess, Result>(*this, &Halfedge_Mesh::their_name, \
                                                      first, second);                    \
  }
#define SCOTTY3D_MESH_FUNCTION(exercise, name, their_name, Result)                         \
  Result PolyMesh::name() {                                                                \
    return call_on_mesh(*this, &Halfedge_Mesh::their_name, "Halfedge_Mesh::" #their_name); \
  }
#define SCOTTY3D_MESH_FUNCTION_OF(exercise, name, their_name, Result, OurArgument, Argument) \
  Result PolyMesh::name(OurArgument argument) {                                              \
    return call_with(*this, &Halfedge_Mesh::their_name, static_cast<Argument>(argument),     \
                     "Halfedge_Mesh::" #their_name);                                         \
  }
#define SCOTTY3D_REFINEMENT(exercise, name, their_name)                              \
  RefinedPositions PolyMesh::name() {                                                \
    return refine(*this, &Halfedge_Mesh::their_name, "Halfedge_Mesh::" #their_name); \
  }
#include "functions.inc"

void PolyMesh::placeExtruded(FaceIter f, const Vector3D& move, double shrink) {
  Halfedge_Mesh theirs;
  MeshBridge bridge(*this, theirs);
  theirs.extrude_positions(bridge.theirs(f), detail::scotty3d::to_floats(move),
                           static_cast<float>(shrink));
  bridge.write_back();
}

void PolyMesh::placeBevelled(FaceIter f, const std::vector<Vector3D>& starts,
                             const Vector3D& direction, double distance) {
  using detail::scotty3d::to_floats;
  Halfedge_Mesh theirs;
  MeshBridge bridge(*this, theirs);
  std::vector<Vec3> places;
  for (const Vector3D& start : starts)
    places.push_back(to_floats(start));
  theirs.bevel_positions(bridge.theirs(f), places, to_floats(direction),
                         static_cast<float>(distance));
  bridge.write_back();
}

void PolyMesh::isotropicRemesh(const RemeshParameters& parameters) {
  Halfedge_Mesh theirs;
  MeshBridge bridge(*this, theirs);
  Halfedge_Mesh::Isotropic_Remesh_Parameters params;
  params.outer_iterations = static_cast<std::uint32_t>(parameters.outerIterations);
  params.longer_factor = static_cast<float>(parameters.longerFactor);
  params.shorter_factor = static_cast<float>(parameters.shorterFactor);
  params.smoothing_iterations = static_cast<std::uint32_t>(parameters.smoothingIterations);
  params.smoothing_step = static_cast<float>(parameters.smoothingStep);
  theirs.isotropic_remesh(params);
  bridge.write_back();
}

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
#define SCOTTY3D_MESH_FUNCTION_OF(exercise, name, their_name, Result, OurArgument, Argument) \
  [[gnu::weak]] Result Halfedge_Mesh::their_name(Argument) SCOTTY3D_UNWRITTEN(their_name)
#define SCOTTY3D_REFINEMENT(exercise, name, their_name) \
  [[gnu::weak]] void Halfedge_Mesh::their_name() SCOTTY3D_UNWRITTEN(their_name)
#include "functions.inc"

[[gnu::weak]] void Halfedge_Mesh::isotropic_remesh(const Isotropic_Remesh_Parameters&)
    SCOTTY3D_UNWRITTEN(isotropic_remesh)

        [[gnu::weak]] void Halfedge_Mesh::extrude_positions(FaceRef, Vec3, float)
            SCOTTY3D_UNWRITTEN(extrude_positions)
                [[gnu::weak]] void Halfedge_Mesh::bevel_positions(FaceRef,
                                                                  const std::vector<Vec3>&,
                                                                  Vec3, float)
                    SCOTTY3D_UNWRITTEN(bevel_positions)
