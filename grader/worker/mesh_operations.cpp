#include "grader/worker/mesh_operations.h"

#include "grader/cases/mesh_input.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"

namespace meshgrade {
namespace {

using meshedit::detail::Inspector;

/// The live vertex with this place among the live ones; nullptr if there are not so many.
const meshedit::Vertex* live_vertex(const meshedit::HalfedgeMesh& mesh, std::uint32_t place) {
  const auto& vertices = Inspector::vertices(mesh);
  for (std::size_t i = 0; i < vertices.slots(); ++i) {
    if (!Inspector::is_live(*vertices.at(i))) continue;
    if (place == 0) return vertices.at(i);
    --place;
  }
  return nullptr;
}

/// The live edge between two vertices. The mesh may be broken: no pointer is followed before it
/// was found among the live half-edges.
meshedit::EdgeIter find_edge(const meshedit::HalfedgeMesh& mesh, const Operation& operation) {
  const meshedit::Vertex* a = live_vertex(mesh, operation.a);
  const meshedit::Vertex* b = live_vertex(mesh, operation.b);
  const auto& halfedges = Inspector::halfedges(mesh);
  const auto& edges = Inspector::edges(mesh);
  for (std::size_t i = 0; i < edges.slots(); ++i) {
    meshedit::Edge* e = edges.at(i);
    const meshedit::Halfedge* h = Inspector::halfedge(*e);
    if (!Inspector::is_live(*e) || halfedges.find(h) < 0) continue;
    const meshedit::Halfedge* t = Inspector::twin(*h);
    if (halfedges.find(t) < 0) continue;
    const meshedit::Vertex* start = Inspector::vertex(*h);
    const meshedit::Vertex* end = Inspector::vertex(*t);
    if ((start == a && end == b) || (start == b && end == a)) return Inspector::handle(e);
  }
  return {};
}

}  // namespace

void run_mesh_operations(WireReader& input, Recorder& recorder) {
  const OperationsInput asked = input.read<OperationsInput>();
  meshedit::HalfedgeMesh mesh;
  build_mesh(asked.mesh, mesh);
  if (asked.anchoring == Anchoring::kElsewhere) anchor_elsewhere(mesh);
  if (asked.anchoring == Anchoring::kOnEdge) {
    anchor_on(find_edge(mesh, asked.operations.at(0)));
  }
  for (const Operation& operation : asked.operations) {
    const meshedit::EdgeIter edge = find_edge(mesh, operation);
    if (asked.anchoring == Anchoring::kOnEachEdge && edge != meshedit::EdgeIter())
      anchor_on(edge, operation.anchors);
    OperationStep step;
    step.edge = dump_handle(mesh, edge);
    recorder.set_state_source([&mesh, step]() mutable {
      step.after = dump_mesh(mesh);
      return to_wire(step);
    });
    if (edge != meshedit::EdgeIter()) {
      step.returned = operation.kind == OperationKind::kFlip
                          ? dump_handle(mesh, mesh.flipEdge(edge))
                          : dump_handle(mesh, mesh.splitEdge(edge));
    }
    step.after = dump_mesh(mesh);
    recorder.add_step(step);
    if (edge == meshedit::EdgeIter()) return;
  }
}

}  // namespace meshgrade
