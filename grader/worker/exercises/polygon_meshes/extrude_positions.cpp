#include "grader/worker/exercises.h"
#include "grader/worker/placements.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_extrude_positions(WireReader& input, Recorder& recorder) {
  run_placements(
      input, recorder,
      [](meshedit::PolyMesh& mesh, meshedit::FaceIter face,
         const std::vector<meshedit::Vector3D>& /*starts*/, const Placement& placement) {
        mesh.placeExtruded(face, to_vector(placement.vector), placement.amount);
      });
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB void PolyMesh::placeExtruded(FaceIter /*f*/, const Vector3D& /*move*/,
                                            double /*shrink*/) {
  notImplemented("PolyMesh::placeExtruded");
}

}  // namespace meshedit
