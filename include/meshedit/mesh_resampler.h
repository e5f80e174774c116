#pragma once

#include "halfedge_mesh.h"

namespace meshedit {

/// Algorithms that change the number of triangles of a mesh.
class MeshResampler {
 public:
  MeshResampler() = default;
  ~MeshResampler() = default;

  /// EXERCISE loop_subdivision. One level of Loop subdivision, by the mesh's splitEdge and
  /// flipEdge or in any other way: every triangle becomes four, and every point is computed
  /// from the positions BEFORE the step.
  ///
  ///   new point of an edge inside        3/8, 3/8 its ends, 1/8, 1/8 the vertices opposite
  ///   old vertex inside, valence n       (1 - n u) itself + u times each neighbour, where
  ///                                      u = 3/16 if n = 3, otherwise 3 / (8 n)
  ///   new point of a boundary edge       1/2, 1/2 its ends
  ///   old vertex on a boundary           3/4 itself, 1/8, 1/8 its two boundary neighbours
  ///
  /// The vertex rule above is Warren's. Loop's own, u = (5/8 - (3/8 + cos(2 pi / n) / 4)^2) /
  /// n, is accepted as well, unless your assignment names one. Boundaries are extra credit.
  /// Calling it again must give the next level.
  MESHEDIT_YOURS void upsample(HalfedgeMesh& mesh);
};

}  // namespace meshedit
