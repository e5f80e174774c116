// What a homework file for the Berkeley skeleton may leave undefined of its MeshResampler: see
// include/dropin. The class itself is the student's and unknown here, so it is declared with
// its functions only. The linker takes this file out of the library only when one of them is
// missing.

#include "grader/worker/stub.h"
#include "meshedit/halfedge_mesh.h"

namespace meshedit {

class CourseMeshResampler {
 public:
  CourseMeshResampler();
  ~CourseMeshResampler();  // NOLINT(performance-trivially-destructible): students define it
  void upsample(HalfedgeMesh& mesh);
};

MESHGRADE_STUB CourseMeshResampler::CourseMeshResampler() = default;
MESHGRADE_STUB CourseMeshResampler::~CourseMeshResampler() = default;

MESHGRADE_STUB void CourseMeshResampler::upsample(HalfedgeMesh& /*mesh*/) {
  notImplemented("MeshResampler::upsample");
}

}  // namespace meshedit
