#pragma once

// Vertex normals from the triangles alone, without half-edges: right ones, and those that known
// misconceptions give.

#include <cstdint>
#include <map>
#include <vector>

#include "grader/judge/misconception.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

enum class NormalWeight {
  kArea,         ///< what is asked
  kEqual,        ///< every face counts the same
  kAngle,        ///< the angle of the face at the vertex
  kAreaSquared,  ///< the area twice: unit normals are not what is weighted
};

/// The unit normal of each vertex of a triangle mesh.
std::vector<Point3> vertex_normals(const PolygonMesh& mesh, NormalWeight weight);

/// Where the boundary loops lead: from each boundary vertex to the next, against the faces.
std::map<std::uint32_t, std::uint32_t> boundary_loops(const PolygonMesh& mesh);

const Misconceptions& normal_misconceptions();

/// The misconceptions that explain all normals of a mesh. `actual` may be shorter than
/// `expected`, if the computation was cut off.
Misconceptions recognize_normals(const PolygonMesh& mesh, const std::vector<Point3>& expected,
                                 const std::vector<Point3>& actual, double tolerance);

}  // namespace meshgrade
