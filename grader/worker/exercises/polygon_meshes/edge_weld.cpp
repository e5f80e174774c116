#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_edge_weld(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::weldEdges);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<EdgeIter> PolyMesh::weldEdges(EdgeIter /*e*/, EdgeIter /*f*/) {
  notImplemented("PolyMesh::weldEdges");
}

}  // namespace meshedit
