#include "grader/cases/mesh_input.h"
#include "grader/mesh/build_mesh.h"
#include "grader/worker/exercises.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_vertex_normal(WireReader& input, Recorder& recorder) {
  const NormalInput asked = input.read<NormalInput>();
  meshedit::HalfedgeMesh mesh;
  build_mesh(asked.mesh, mesh);
  if (asked.anchoring == Anchoring::kElsewhere) anchor_elsewhere(mesh);
  for (meshedit::VertexCIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); ++v) {
    const meshedit::Vector3D normal = v->normal();
    recorder.add_step(Point3{normal.x, normal.y, normal.z});
  }
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB Vector3D Vertex::normal() const {
  notImplemented("Vertex::normal");
}

}  // namespace meshedit
