#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_face_collapse(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::collapseFace);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<VertexIter> PolyMesh::collapseFace(FaceIter /*f*/) {
  notImplemented("PolyMesh::collapseFace");
}

}  // namespace meshedit
