#include "grader/cases/remesh_input.h"
#include "grader/worker/exercises.h"
#include "grader/worker/stub.h"
#include "grader/worker/whole_mesh.h"

namespace meshgrade {

void run_isotropic_remeshing(WireReader& input, Recorder& recorder) {
  const auto asked = input.read<RemeshInput>();
  meshedit::RemeshParameters parameters;
  parameters.outerIterations = asked.settings.outer;
  parameters.longerFactor = asked.settings.longer;
  parameters.shorterFactor = asked.settings.shorter;
  parameters.smoothingIterations = asked.settings.smoothing;
  parameters.smoothingStep = asked.settings.step;
  with_mesh(asked.mesh, asked.anchor_turns, [&](meshedit::PolyMesh& mesh) {
    recorder.set_state_source([&mesh] { return to_wire(dump_mesh(mesh)); });
    mesh.isotropicRemesh(parameters);
    recorder.add_step(dump_mesh(mesh));
  });
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB void PolyMesh::isotropicRemesh(const RemeshParameters& /*parameters*/) {
  notImplemented("PolyMesh::isotropicRemesh");
}

}  // namespace meshedit
