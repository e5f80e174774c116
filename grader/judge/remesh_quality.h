#pragma once

// How good the triangles of a mesh are, and how far it is from another one.

#include "grader/operations/face_lists.h"

namespace meshgrade {

struct MeshQuality {
  double mean_length = 0.0;
  double variation = 0.0;  ///< the standard deviation of edge lengths, divided by their mean
  double deviation = 0.0;  ///< the mean of |n - 6|, n being the number of edges at a vertex
};

/// @param mesh  keeps all mesh rules; two edges may have the same ends
MeshQuality quality_of(const MeshDump& mesh);

/// The distance of a point to a surface of triangles: to its nearest point.
double distance_to(const FaceLists& triangles, const Point3& point);

}  // namespace meshgrade
