/*
 * Student solution, not begun. The forms of 2017 to 2019.
 */

#include "student_code.h"
#include "mutablePriorityQueue.h"

using namespace std;

namespace CGL
{
  void BezierCurve::evaluateStep()
  {
    // TODO Part 1.
    // evaluatedLevels holds 4 points, then 3, 2 and 1.
  }


  Vector3D BezierPatch::evaluate(double u, double v) const
  {
    // TODO Part 2.
    return Vector3D();
  }

  Vector3D BezierPatch::evaluate1D(std::vector<Vector3D> points, double t) const
  {
    // TODO Part 2.
    // The points are 4.
    return Vector3D();
 }



  Vector3D Vertex::normal( void ) const
  {
    // TODO Part 3.
    return Vector3D();
  }

  EdgeIter HalfedgeMesh::flipEdge( EdgeIter e0 )
  {
    // TODO Part 4.
    return e0;
  }

  VertexIter HalfedgeMesh::splitEdge( EdgeIter e0 )
  {
    // TODO Part 5.
    VertexIter newVertex;
    return newVertex;
  }



  void MeshResampler::upsample( HalfedgeMesh& mesh )
  {
    // TODO Part 6.
    /* Split each edge, flip, copy positions; { mind } the braces. */
  }
}
