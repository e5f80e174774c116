#include "grader/worker/view_task.h"

#include <optional>

#include "grader/cases/view_input.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"
#include "meshedit/mesh_resampler.h"

namespace meshgrade {
namespace {

using meshedit::detail::Inspector;

/// The edge with this number; none if it is not there.
meshedit::EdgeIter edge_of(const meshedit::HalfedgeMesh& mesh, Ref number) {
  const auto& edges = Inspector::edges(mesh);
  if (number >= edges.slots() || !Inspector::is_live(*edges.at(number))) return {};
  return Inspector::handle(edges.at(number));
}

/// @return what the function returned; nothing if the edge is not there
std::optional<Ref> call(meshedit::HalfedgeMesh& mesh, const ViewOperation& operation) {
  if (operation.picked.empty()) {
    meshedit::MeshResampler().upsample(mesh);
    return kUnsetRef;
  }
  const meshedit::EdgeIter edge = edge_of(mesh, operation.picked[0]);
  if (edge == meshedit::EdgeIter()) return {};
  if (operation.exercise == "edge_flip") return dump_handle(mesh, mesh.flipEdge(edge));
  return dump_handle(mesh, mesh.splitEdge(edge));
}

}  // namespace

void run_view(WireReader& input, Recorder& recorder) {
  const ViewInput asked = input.read<ViewInput>();
  meshedit::HalfedgeMesh mesh;
  build_mesh(asked.mesh, mesh);
  recorder.set_state_source([&mesh] { return to_wire(ViewStep{kUnsetRef, dump_mesh(mesh)}); });
  for (std::uint32_t i = 0; i < asked.operations.size(); ++i) {
    const std::optional<Ref> returned = call(mesh, asked.operations[i]);
    if (!returned) return;
    if (i >= asked.first_told) recorder.add_step(ViewStep{*returned, dump_mesh(mesh)});
  }
  if (!asked.normals) return;
  for (meshedit::VertexCIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    const meshedit::Vector3D normal = v->normal();
    recorder.add_step(Point3{normal.x, normal.y, normal.z});
  }
}

}  // namespace meshgrade
