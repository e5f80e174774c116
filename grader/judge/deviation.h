#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// How far the vertices of a subdivided mesh are from where OpenSubdiv puts them. Lengths are
/// fractions of the diagonal of the right mesh's bounding box.
struct Deviation {
  std::string weights;            ///< the published ones that are nearest: "Loop's weights"
  std::vector<double> of_vertex;  ///< by the student's numbers; not finite: no such vertex
  std::vector<Ref> worst;         ///< those that are off by more than is allowed, worst first
  double largest = 0.0;
  double allowed = 0.0;

  bool empty() const { return of_vertex.empty(); }
};

/// @param match    right vertex -> the student's
/// @param size     of the mesh, in its own units
/// @param allowed  relative to the size
Deviation measure_deviation(const std::vector<Point3>& expected, const MeshDump& mesh,
                            const std::vector<Ref>& match, double size, double allowed);

}  // namespace meshgrade
