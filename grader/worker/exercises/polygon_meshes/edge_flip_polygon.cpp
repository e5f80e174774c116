#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_edge_flip_polygon(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::flipEdge);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<EdgeIter> PolyMesh::flipEdge(EdgeIter /*e*/) {
  notImplemented("PolyMesh::flipEdge");
}

}  // namespace meshedit
