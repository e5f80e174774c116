#include "grader/worker/exercises.h"
#include "grader/worker/stub.h"
#include "grader/worker/whole_mesh.h"

namespace meshgrade {

void run_loop_refinement(WireReader& input, Recorder& recorder) {
  run_on_whole_mesh(input, recorder, [](meshedit::PolyMesh& mesh) {
    const bool done = mesh.loopSubdivide();
    return RefusableStep{done ? 1U : 0U, dump_mesh(mesh)};
  });
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB bool PolyMesh::loopSubdivide() {
  notImplemented("PolyMesh::loopSubdivide");
}

}  // namespace meshedit
