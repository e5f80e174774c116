#pragma once

// Functions that place the corners of a face, called and written down. C++17.

#include "grader/base/wire.h"
#include "grader/cases/placement_input.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"
#include "grader/worker/recorder.h"
#include "meshedit/poly_mesh.h"

namespace meshgrade {

/// Unpacks a PlacementInput, and records the mesh after each call.
/// @param call  calls the student's function with a mesh, the face, where its corners were at
///              first (from the start of its half-edge on), and the placement
template <class Call>
void run_placements(WireReader& input, Recorder& recorder, Call call) {
  const auto asked = input.read<PlacementInput>();
  meshedit::PolyMesh mesh;
  build_mesh(asked.mesh, mesh);
  for (std::uint32_t i = 0; i < asked.anchor_turns; ++i)
    anchor_elsewhere(mesh);
  recorder.set_state_source([&mesh] { return to_wire(dump_mesh(mesh)); });
  meshedit::FaceIter face = mesh.facesBegin();
  for (std::uint32_t i = 0; i < asked.face; ++i)
    ++face;
  std::vector<meshedit::Vector3D> starts;
  const meshedit::HalfedgeIter first = face->halfedge();
  meshedit::HalfedgeIter h = first;
  do {
    starts.push_back(h->vertex()->position);
    h = h->next();
  } while (h != first);
  for (const Placement& placement : asked.calls) {
    call(mesh, face, starts, placement);
    recorder.add_step(dump_mesh(mesh));
  }
}

inline meshedit::Vector3D to_vector(const Point3& p) {
  return {p[0], p[1], p[2]};
}

}  // namespace meshgrade
