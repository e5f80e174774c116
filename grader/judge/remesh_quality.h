#pragma once

// How good the triangles of a mesh are.

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

struct MeshQuality {
  double mean_length = 0.0;
  double variation = 0.0;  ///< the standard deviation of edge lengths, divided by their mean
  double deviation = 0.0;  ///< the mean of |n - 6|, n being the number of edges at a vertex
};

/// @param mesh  keeps all mesh rules; two edges may have the same ends
MeshQuality quality_of(const MeshDump& mesh);

}  // namespace meshgrade
