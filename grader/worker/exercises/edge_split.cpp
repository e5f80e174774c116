#include "grader/worker/exercises.h"
#include "grader/worker/mesh_operations.h"
#include "grader/worker/stub.h"
#include "meshedit/halfedge_mesh.h"

namespace meshgrade {

void run_edge_split(WireReader& input, Recorder& recorder) {
  run_mesh_operations(input, recorder);
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB VertexIter HalfedgeMesh::splitEdge(EdgeIter /*e0*/) {
  notImplemented("HalfedgeMesh::splitEdge");
}

}  // namespace meshedit
