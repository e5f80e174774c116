#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_face_remove(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::removeFace);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<FaceIter> PolyMesh::removeFace(FaceIter /*f*/) {
  notImplemented("PolyMesh::removeFace");
}

}  // namespace meshedit
