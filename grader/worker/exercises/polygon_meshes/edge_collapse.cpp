#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_edge_collapse(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::collapseEdge);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<VertexIter> PolyMesh::collapseEdge(EdgeIter /*e*/) {
  notImplemented("PolyMesh::collapseEdge");
}

}  // namespace meshedit
