// Lets the grader call the functions of a homework for Scotty3D of Fall 2020 to Spring 2022.
// Compiled with each such submission. Each of the grader's functions makes a Halfedge_Mesh,
// calls the student's function on it, and writes back what it has become.

#include "dropin_scotty3d/detail/calls.h"
#include "mesh_access.h"

namespace meshedit {
namespace {

using detail::scotty3d::call_on_mesh;
using detail::scotty3d::MeshAccess;

/// What a function of the homework has left in the members new_pos. Boundary faces have one in
/// the course, and none here.
RefinedPositions positions_in(Halfedge_Mesh& theirs,
                              const detail::scotty3d::MeshBridge<MeshAccess>& bridge) {
  const auto ours = [](const Vec3& p) { return Vector3D(p.x, p.y, p.z); };
  RefinedPositions positions;
  for (auto v = theirs.vertices.begin(); v != theirs.vertices.end(); ++v)
    positions.vertices[bridge.ours(v)] = ours(v->new_pos);
  for (auto e = theirs.edges.begin(); e != theirs.edges.end(); ++e)
    positions.edges[bridge.ours(e)] = ours(e->new_pos);
  for (auto f = theirs.faces.begin(); f != theirs.faces.end(); ++f) {
    if (!f->boundary) positions.faces[bridge.ours(f)] = ours(f->new_pos);
  }
  return positions;
}

RefinedPositions refine(PolyMesh& mesh, void (Halfedge_Mesh::*function)()) {
  Halfedge_Mesh theirs;
  detail::scotty3d::MeshBridge<MeshAccess> bridge(mesh, theirs);
  (theirs.*function)();
  MeshAccess::finish(theirs);
  bridge.write_back();
  const detail::StepPause pause;
  return positions_in(theirs, bridge);
}

/// Whether the course's program calls loop_subdivide() at all.
bool takes_loop(const PolyMesh& mesh) {
  const detail::StepPause pause;
  bool has_others = mesh.nBoundaries() != 0;
  for (FaceCIter f = mesh.facesBegin(); f != mesh.facesEnd(); ++f)
    has_others = has_others || f->degree() != 3;
  return !has_others;
}

}  // namespace

#define SCOTTY3D_FUNCTION(exercise, name, their_name, Result, Argument)                  \
  std::optional<Handle<Result>> PolyMesh::name(Handle<Argument> argument) {              \
    return detail::scotty3d::call<MeshAccess, Result>(*this, &Halfedge_Mesh::their_name, \
                                                      argument);                         \
  }
#define SCOTTY3D_REFINEMENT(exercise, name, their_name) \
  RefinedPositions PolyMesh::name() {                   \
    return refine(*this, &Halfedge_Mesh::their_name);   \
  }
#include "functions.inc"

void PolyMesh::triangulate() {
  call_on_mesh<MeshAccess>(*this, &Halfedge_Mesh::triangulate);
}

bool PolyMesh::loopSubdivide() {
  if (!takes_loop(*this)) return false;
  call_on_mesh<MeshAccess>(*this, &Halfedge_Mesh::loop_subdivide);
  return true;
}

}  // namespace meshedit

// Replaced by the student's own definitions when the worker is linked.
#define SCOTTY3D_UNWRITTEN(their_name) \
  { meshedit::notImplemented("Halfedge_Mesh::" #their_name); }
#define SCOTTY3D_FUNCTION(exercise, name, their_name, Result, Argument)              \
  [[gnu::weak]] std::optional<Halfedge_Mesh::Result##Ref> Halfedge_Mesh::their_name( \
      Argument##Ref) SCOTTY3D_UNWRITTEN(their_name)
#define SCOTTY3D_MESH_FUNCTION(exercise, name, their_name, Result) \
  [[gnu::weak]] void Halfedge_Mesh::their_name() SCOTTY3D_UNWRITTEN(their_name)
#define SCOTTY3D_REFINEMENT(exercise, name, their_name) \
  [[gnu::weak]] void Halfedge_Mesh::their_name() SCOTTY3D_UNWRITTEN(their_name)
#include "functions.inc"
