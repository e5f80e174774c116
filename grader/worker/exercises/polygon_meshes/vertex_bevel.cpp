#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_vertex_bevel(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::bevelVertex);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<FaceIter> PolyMesh::bevelVertex(VertexIter /*v*/) {
  notImplemented("PolyMesh::bevelVertex");
}

}  // namespace meshedit
