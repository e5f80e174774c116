#include "grader/worker/exercises.h"
#include "grader/worker/local_operations.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_face_extrude(WireReader& input, Recorder& recorder) {
  run_local_operations(input, recorder, &meshedit::PolyMesh::extrudeFace);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB std::optional<FaceIter> PolyMesh::extrudeFace(FaceIter /*f*/) {
  notImplemented("PolyMesh::extrudeFace");
}

}  // namespace meshedit
