#pragma once

// Functions that work on a whole mesh, called and written down. C++17.

#include "grader/base/wire.h"
#include "grader/cases/whole_mesh_input.h"
#include "grader/mesh/dump_mesh.h"
#include "grader/worker/bench.h"
#include "grader/worker/recorder.h"

namespace meshgrade {
namespace whole_mesh_detail {

template <class Element>
std::vector<PlacedElement> dump_positions(
    const meshedit::HalfedgeMesh& mesh,
    const std::map<meshedit::Handle<Element>, meshedit::Vector3D>& positions) {
  std::vector<PlacedElement> placed;
  for (const auto& [element, at] : positions)
    placed.push_back({dump_handle(mesh, element), dump_detail::to_point(at)});
  return placed;
}

}  // namespace whole_mesh_detail

/// Unpacks a WholeMeshInput, and calls and records as often as asked.
/// @param call  calls the student's function on a mesh, and returns what is to be recorded
template <class Call>
void run_on_whole_mesh(WireReader& input, Recorder& recorder, Call call) {
  const auto asked = input.read<WholeMeshInput>();
  with_mesh(asked.mesh, asked.anchor_turns, [&](meshedit::PolyMesh& mesh) {
    recorder.set_state_source([&mesh] { return to_wire(dump_mesh(mesh)); });
    for (std::uint32_t i = 0; i < asked.times; ++i)
      recorder.add_step(call(mesh));
  });
}

namespace whole_mesh_detail {

/// Calls a function that computes where the vertices of the next level lie, and records a
/// RefinementStep. @return the next level, if there is one
inline std::optional<PolygonMesh> refine(
    meshedit::PolyMesh& mesh, Recorder& recorder,
    meshedit::RefinedPositions (meshedit::PolyMesh::*function)()) {
  const MeshDump before = dump_mesh(mesh);
  const meshedit::RefinedPositions positions = (mesh.*function)();
  RefinementStep step;
  step.after = dump_mesh(mesh);
  step.vertices = dump_positions(mesh, positions.vertices);
  step.edges = dump_positions(mesh, positions.edges);
  step.faces = dump_positions(mesh, positions.faces);
  recorder.add_step(step);
  const auto points = complete_points(before, step);
  if (!points) return {};
  return refined_mesh(before, *points);
}

}  // namespace whole_mesh_detail

/// The same for a function that computes where the vertices of the next level lie: records a
/// RefinementStep after each call, makes the next level, and asks again. Ends where there is
/// no next level.
inline void run_refinements(WireReader& input, Recorder& recorder,
                            meshedit::RefinedPositions (meshedit::PolyMesh::*function)()) {
  const auto asked = input.read<WholeMeshInput>();
  std::optional<PolygonMesh> level = asked.mesh;
  for (std::uint32_t i = 0; i < asked.times && level; ++i) {
    std::optional<PolygonMesh> next;
    with_mesh(*level, asked.anchor_turns, [&](meshedit::PolyMesh& mesh) {
      next = whole_mesh_detail::refine(mesh, recorder, function);
    });
    level = std::move(next);
  }
  if (viewers_bench != nullptr && level) viewers_bench->put(*level);
}

}  // namespace meshgrade
