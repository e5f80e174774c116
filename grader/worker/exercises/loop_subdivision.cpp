#include "grader/cases/mesh_input.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"
#include "grader/worker/exercises.h"
#include "grader/worker/stub.h"
#include "meshedit/mesh_resampler.h"

namespace meshgrade {

void run_loop_subdivision(WireReader& input, Recorder& recorder) {
  const SubdivisionInput asked = input.read<SubdivisionInput>();
  meshedit::HalfedgeMesh mesh;
  build_mesh(asked.mesh, mesh);
  if (asked.anchoring == Anchoring::kElsewhere) anchor_elsewhere(mesh);
  if (asked.anchoring == Anchoring::kFromEarlier) anchor_from_earlier(mesh);
  recorder.set_state_source([&mesh] { return to_wire(dump_mesh(mesh)); });
  meshedit::MeshResampler resampler;
  for (std::uint32_t level = 0; level < asked.levels; ++level) {
    resampler.upsample(mesh);
    recorder.add_step(dump_mesh(mesh));
  }
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB void MeshResampler::upsample(HalfedgeMesh& /*mesh*/) {
  notImplemented("MeshResampler::upsample");
}

}  // namespace meshedit
