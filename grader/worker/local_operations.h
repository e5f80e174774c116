#pragma once

// Operations on one element of a mesh, called and written down. C++17.

#include <optional>
#include <tuple>
#include <utility>

#include "grader/base/wire.h"
#include "grader/cases/local_operation_input.h"
#include "grader/mesh/dump_mesh.h"
#include "grader/worker/bench.h"
#include "grader/worker/recorder.h"

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

template <class... T, std::size_t... I>
std::tuple<meshedit::Handle<T>...> pick_all(const meshedit::HalfedgeMesh& mesh,
                                            const std::uint32_t* places,
                                            std::index_sequence<I...> /*order*/) {
  return {pick<T>(mesh, places[I])...};
}

}  // namespace local_operations_detail

/// The results of the student's functions.
template <class Out>
using MaybeHandle = std::optional<meshedit::Handle<Out>>;

/// Unpacks a LocalOperationInput, calls the student's function, and records a LocalStep for
/// each operation.
/// @tparam In the kinds of the elements that are picked for one operation
template <class... In, class Operation>
void run_picked_operations(WireReader& input, Recorder& recorder, Operation operation) {
  const auto asked = input.read<LocalOperationInput>();
  with_mesh(asked.mesh, asked.anchor_turns, [&](meshedit::PolyMesh& mesh) {
    for (std::size_t i = 0; i + sizeof...(In) <= asked.places.size(); i += sizeof...(In)) {
      const auto elements = local_operations_detail::pick_all<In...>(
          mesh, &asked.places[i], std::index_sequence_for<In...>());
      LocalStep step;
      step.picked = dump_handle(mesh, std::get<0>(elements));
      if constexpr (sizeof...(In) == 2) step.partner = dump_handle(mesh, std::get<1>(elements));
      recorder.set_state_source([&mesh, step]() mutable {
        step.after = dump_mesh(mesh);
        return to_wire(step);
      });
      const auto returned =
          std::apply([&](auto... element) { return (mesh.*operation)(element...); }, elements);
      step.refused = returned ? 0 : 1;
      if (returned) step.returned = dump_handle(mesh, *returned);
      step.after = dump_mesh(mesh);
      recorder.add_step(step);
    }
  });
}

template <class Out, class In>
void run_local_operations(
    WireReader& input, Recorder& recorder,
    MaybeHandle<Out> (meshedit::PolyMesh::*operation)(meshedit::Handle<In>)) {
  run_picked_operations<In>(input, recorder, operation);
}

/// The same of a function that takes two elements.
template <class Out, class In>
void run_local_operations(WireReader& input, Recorder& recorder,
                          MaybeHandle<Out> (meshedit::PolyMesh::*operation)(
                              meshedit::Handle<In>, meshedit::Handle<In>)) {
  run_picked_operations<In, In>(input, recorder, operation);
}

}  // namespace meshgrade
