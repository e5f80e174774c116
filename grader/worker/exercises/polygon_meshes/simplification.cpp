#include "grader/cases/simplification_input.h"
#include "grader/worker/exercises.h"
#include "grader/worker/stub.h"
#include "grader/worker/whole_mesh.h"

namespace meshgrade {

void run_simplification(WireReader& input, Recorder& recorder) {
  const auto asked = input.read<SimplificationInput>();
  with_mesh(asked.mesh, asked.anchor_turns, [&](meshedit::PolyMesh& mesh) {
    recorder.set_state_source([&mesh] { return to_wire(dump_mesh(mesh)); });
    const bool done = mesh.simplify(asked.ratio);
    recorder.add_step(RefusableStep{done ? 1U : 0U, dump_mesh(mesh)});
  });
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB bool PolyMesh::simplify(double /*ratio*/) {
  notImplemented("PolyMesh::simplify");
}

}  // namespace meshedit
