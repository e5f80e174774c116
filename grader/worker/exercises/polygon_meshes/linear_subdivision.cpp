#include "grader/worker/exercises.h"
#include "grader/worker/stub.h"
#include "grader/worker/whole_mesh.h"

namespace meshgrade {

void run_linear_subdivision(WireReader& input, Recorder& recorder) {
  run_refinements(input, recorder, &meshedit::PolyMesh::linearPositions);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB RefinedPositions PolyMesh::linearPositions() {
  notImplemented("PolyMesh::linearPositions");
}

}  // namespace meshedit
