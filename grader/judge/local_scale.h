#pragma once

// How far a position may be off, by the lengths around it: a tolerance relative to the whole
// mesh would judge a small part of it loosely.

#include <string>
#include <vector>

#include "grader/judge/loop_misconceptions.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

struct LocalScale {
  double length = 1.0;            ///< that errors are told by
  double allowed = 0.0;           ///< how far the position may be off, in the mesh's own units
  const char* what = "the size";  ///< what the length is: "the length of the edge"
};

/// "1.2e-02 of the length of the edge (allowed: 1e-05)"
std::string error_text(double error, const LocalScale& scale);

/// Of the middle of an edge.
/// @param tolerance  a part of the length. On top comes what arithmetic in float may be off
///                   where the coordinates are this large.
LocalScale scale_of_edge(const Point3& a, const Point3& b, double tolerance);

/// Of each vertex of a refined mesh: of an old vertex by the mean length of its edges in the
/// mesh before the step, of a new one by the length of the edge that it lies on.
std::vector<LocalScale> scales_of_level(const PolygonMesh& old,
                                        const std::vector<Origin>& origins, double tolerance);

/// Of each vertex normal, which has length 1: the tolerance, and what positions in float may
/// turn the faces around by.
std::vector<LocalScale> scales_of_normals(const PolygonMesh& mesh, double tolerance);

/// True if no point is off by more than is allowed.
bool are_within(const std::vector<Point3>& expected, const std::vector<Point3>& actual,
                const std::vector<LocalScale>& scales);

/// The point that is off by most, as a part of what is allowed there, and by how much it is
/// off.
WorstPoint worst_by_scale(const std::vector<Point3>& expected,
                          const std::vector<Point3>& actual,
                          const std::vector<LocalScale>& scales);

}  // namespace meshgrade
