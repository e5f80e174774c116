#pragma once

// A wrong subdivided surface as a picture shows it: the triangles, and which vertices are
// wrong. Data only: how it is drawn is the report's business.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "grader/judge/local_scale.h"
#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

struct TriangleSurface {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Point3> positions;
};

/// A vertex that is wrong.
struct SurfaceMark {
  std::uint32_t vertex = 0;    ///< of `yours`
  std::uint32_t expected = 0;  ///< the same vertex in `expected`
  std::string name;            ///< "v12"
  std::string text;            ///< "off by 0.1 of the length of the old edge, ..."
  double error = 0.0;          ///< what the marks are ordered by
};

/// No triangles: there is no picture.
struct SurfaceFigure {
  TriangleSurface yours;
  TriangleSurface expected;
  bool is_misplaced = false;       ///< vertices are in wrong places, not joined in a wrong way
  std::vector<SurfaceMark> marks;  ///< the worst first
  std::size_t left_out = 0;  ///< triangles of yours too far from the worst vertex to be shown

  bool empty() const { return yours.triangles.empty(); }
};

/// Vertices in wrong places. Both meshes keep all mesh rules; `match` leads from the vertices
/// of the right one to those of the student's.
///
/// @param expected  the right places, by the numbers of the right mesh
/// @param scales    how far each vertex of the right mesh may be off
SurfaceFigure figure_of_positions(const MeshDump& right, const std::vector<Point3>& expected,
                                  const MeshDump& mesh, const std::vector<Ref>& match,
                                  const std::vector<LocalScale>& scales);

/// Vertices that are joined to too many or too few others. Both meshes keep all mesh rules;
/// `match` has kUnsetRef where nothing is known.
SurfaceFigure figure_of_connectivity(const MeshDump& right, const MeshDump& mesh,
                                     const std::vector<Ref>& match);

/// How many half-edges leave each vertex.
std::vector<std::size_t> valences(const MeshDump& mesh);

}  // namespace meshgrade
