#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_edge_split_polygon(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::splitEdge);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<VertexIter> PolyMesh::splitEdge(EdgeIter /*e*/) {
  notImplemented("PolyMesh::splitEdge");
}

}  // namespace meshedit
