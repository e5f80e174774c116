#include "grader/worker/exercises.h"
#include "grader/worker/stub.h"
#include "grader/worker/whole_mesh.h"

namespace meshgrade {

void run_catmull_clark(WireReader& input, Recorder& recorder) {
  run_refinements(input, recorder, &meshedit::PolyMesh::catmullClarkPositions);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB RefinedPositions PolyMesh::catmullClarkPositions() {
  notImplemented("PolyMesh::catmullClarkPositions");
}

}  // namespace meshedit
