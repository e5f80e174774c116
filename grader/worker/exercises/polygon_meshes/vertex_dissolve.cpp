#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_vertex_dissolve(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::dissolveVertex);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<FaceIter> PolyMesh::dissolveVertex(VertexIter /*v*/) {
  notImplemented("PolyMesh::dissolveVertex");
}

}  // namespace meshedit
