#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_vertex_inset(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::insetVertex);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<VertexIter> PolyMesh::insetVertex(FaceIter /*f*/) {
  notImplemented("PolyMesh::insetVertex");
}

}  // namespace meshedit
