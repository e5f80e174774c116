#pragma once

// A wrong subdivided surface as a picture shows it: the triangles, and which vertices are
// wrong. Data only: how it is drawn is the report's business.

#include <string>
#include <vector>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// A vertex that is wrong.
struct SurfaceMark {
  std::uint32_t vertex = 0;  ///< of the figure
  std::string name;          ///< "v12"
  std::string text;          ///< "off by 0.1 of the size (allowed: 1e-05)"
  double error = 0.0;        ///< what the marks are ordered by
};

/// No triangles: there is no picture.
struct SurfaceFigure {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Point3> yours;
  std::vector<Point3> expected;    ///< the same vertices; empty if the surface itself is wrong
  std::vector<SurfaceMark> marks;  ///< the worst first
  std::size_t left_out = 0;        ///< triangles too far from the worst vertex to be shown

  bool empty() const { return triangles.empty(); }
};

/// A mesh whose vertices are in wrong places. It keeps all mesh rules; `match` leads from the
/// vertices of the right mesh to its own.
///
/// @param expected  by the numbers of the right mesh
/// @param allowed   how far a vertex may be off
/// @param size      of the mesh, to tell errors by
SurfaceFigure figure_of_positions(const MeshDump& mesh, const std::vector<Ref>& match,
                                  const std::vector<Point3>& expected, double allowed,
                                  double size);

/// A mesh that is joined in a wrong way. It keeps all mesh rules.
///
/// @param edges  how many edges each vertex must have; 0 where nothing is known
SurfaceFigure figure_of_connectivity(const MeshDump& mesh,
                                     const std::vector<std::size_t>& edges);

}  // namespace meshgrade
