#include "grader/worker/exercises.h"
#include "grader/worker/placements.h"
#include "grader/worker/stub.h"

namespace meshgrade {

void run_bevel_positions(WireReader& input, Recorder& recorder) {
  run_placements(input, recorder,
                 [](meshedit::PolyMesh& mesh, meshedit::FaceIter face,
                    const std::vector<meshedit::Vector3D>& starts, const Placement& placement) {
                   mesh.placeBevelled(face, starts, to_vector(placement.vector),
                                      placement.amount);
                 });
}

}  // namespace meshgrade

namespace meshedit {

MESHGRADE_STUB void PolyMesh::placeBevelled(FaceIter /*f*/,
                                            const std::vector<Vector3D>& /*starts*/,
                                            const Vector3D& /*direction*/,
                                            double /*distance*/) {
  notImplemented("PolyMesh::placeBevelled");
}

}  // namespace meshedit
