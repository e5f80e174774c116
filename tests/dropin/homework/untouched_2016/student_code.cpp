#include "student_code.h"
#include "mutablePriorityQueue.h"

namespace CGL
{
  void BezierPatch::preprocess()
  {
    // TODO Part 1.
  }

  Vector3D BezierPatch::evaluate(double u, double v) const
  {
    // TODO Part 1.
    return Vector3D();
  }

  void BezierPatch::add2mesh(Polymesh* mesh) const
  {
    // TODO Part 1.
  }

  Vector3D Vertex::normal( void ) const
  {
    // TODO Part 2.
    return Vector3D(0, 0, 0);
  }

  EdgeIter HalfedgeMesh::flipEdge( EdgeIter e0 )
  {
    // TODO Part 4.
    return EdgeIter();
  }

  VertexIter HalfedgeMesh::splitEdge( EdgeIter e0 )
  {
    showError("splitEdge() is to do.");
    return VertexIter();
  }

  void MeshResampler::upsample( HalfedgeMesh& mesh )
  {
    // TODO Part 6.
  }
}
