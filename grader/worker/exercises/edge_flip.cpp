#include "grader/worker/exercises.h"
#include "grader/worker/mesh_operations.h"
#include "grader/worker/stub.h"
#include "meshedit/halfedge_mesh.h"

namespace meshgrade {

void run_edge_flip(WireReader& input, Recorder& recorder) {
  run_mesh_operations(input, recorder);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB EdgeIter HalfedgeMesh::flipEdge(EdgeIter /*e0*/) {
  notImplemented("HalfedgeMesh::flipEdge");
}

}  // namespace meshedit
