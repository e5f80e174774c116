#include "grader/worker/exercises.h"
#include "grader/worker/stub.h"
#include "grader/worker/whole_mesh.h"

namespace meshgrade {

void run_triangulation(WireReader& input, Recorder& recorder) {
  run_on_whole_mesh(input, recorder, [](meshedit::PolyMesh& mesh) {
    mesh.triangulate();
    return dump_mesh(mesh);
  });
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB void PolyMesh::triangulate() {
  notImplemented("PolyMesh::triangulate");
}

}  // namespace meshedit
