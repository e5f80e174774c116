#ifndef STUDENT_CODE_H
#define STUDENT_CODE_H

#include "halfEdgeMesh.h"
#include "bezierPatch.h"
#include "bezierCurve.h"
#include "mutablePriorityQueue.h"

using namespace std;

namespace CGL {

  // my helpers
  static Vector3D weighted(double w, const Vector3D &sum) { return w * sum; }
  Vector3D neighborSum(VertexIter v);

  class MeshResampler {

  public:

    MeshResampler() : calls(0) {}
    ~MeshResampler() {}

    void upsample(HalfedgeMesh& mesh);

  private:
    void markOld(HalfedgeMesh& mesh);
    int calls;
    vector<Vector3D> scratch;
  };

}

#endif
