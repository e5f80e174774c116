#pragma once

// Operations on one element of a mesh, called and written down. C++17.

#include <optional>

#include "grader/base/wire.h"
#include "grader/cases/local_operation_input.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"
#include "grader/worker/recorder.h"
#include "meshedit/poly_mesh.h"

namespace meshgrade {
namespace local_operations_detail {

using meshedit::detail::Inspector;

inline const auto& pool_of(const meshedit::HalfedgeMesh& mesh, const meshedit::Vertex*) {
  return Inspector::vertices(mesh);
}
inline const auto& pool_of(const meshedit::HalfedgeMesh& mesh, const meshedit::Edge*) {
  return Inspector::edges(mesh);
}
inline const auto& pool_of(const meshedit::HalfedgeMesh& mesh, const meshedit::Face*) {
  return Inspector::faces(mesh);
}

/// The live element with this place among the live ones of its kind; counted on from the
/// beginning if there are fewer. An unset handle if there is none.
template <class T>
meshedit::Handle<T> pick(const meshedit::HalfedgeMesh& mesh, std::uint32_t place) {
  const auto& pool = pool_of(mesh, static_cast<T*>(nullptr));
  std::vector<T*> live;
  for (std::size_t i = 0; i < pool.slots(); ++i) {
    if (Inspector::is_live(*pool.at(i))) live.push_back(pool.at(i));
  }
  return live.empty() ? meshedit::Handle<T>() : Inspector::handle(live[place % live.size()]);
}

}  // namespace local_operations_detail

/// Unpacks a LocalOperationInput, calls the student's function, and records a LocalStep for
/// each element that is picked.
template <class Out, class In>
void run_local_operations(WireReader& input, Recorder& recorder,
                          std::optional<meshedit::Handle<Out>> (meshedit::PolyMesh::*operation)(
                              meshedit::Handle<In>)) {
  const auto asked = input.read<LocalOperationInput>();
  meshedit::PolyMesh mesh;
  build_mesh(asked.mesh, mesh);
  for (std::uint32_t i = 0; i < asked.anchor_turns; ++i)
    anchor_elsewhere(mesh);
  for (std::uint32_t place : asked.places) {
    const auto element = local_operations_detail::pick<In>(mesh, place);
    LocalStep step;
    step.picked = dump_handle(mesh, element);
    recorder.set_state_source([&mesh, step]() mutable {
      step.after = dump_mesh(mesh);
      return to_wire(step);
    });
    const auto returned = (mesh.*operation)(element);
    step.refused = returned ? 0 : 1;
    if (returned) step.returned = dump_handle(mesh, *returned);
    step.after = dump_mesh(mesh);
    recorder.add_step(step);
  }
}

}  // namespace meshgrade
