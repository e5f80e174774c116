#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_edge_dissolve(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::dissolveEdge);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<FaceIter> PolyMesh::dissolveEdge(EdgeIter /*e*/) {
  notImplemented("PolyMesh::dissolveEdge");
}

}  // namespace meshedit
