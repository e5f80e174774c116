#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_edge_bevel(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::bevelEdge);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<FaceIter> PolyMesh::bevelEdge(EdgeIter /*e*/) {
  notImplemented("PolyMesh::bevelEdge");
}

}  // namespace meshedit
