#pragma once

// Finds out which vertex of a subdivided mesh is which, whatever the solution numbers its
// elements like: it may keep the old ones, or build a new mesh.

#include <map>
#include <string>
#include <vector>

#include "grader/judge/local_scale.h"
#include "grader/judge/loop_misconceptions.h"
#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// A right answer for one level: the same surface for all variants, with other positions.
struct Level {
  MeshDump surface;
  std::vector<Origin> origins;  ///< of its vertices
  std::map<std::string, PolygonMesh> by_variant;
};

/// How many of these points are further from the right ones than is allowed there.
std::size_t count_wrong(const PolygonMesh& right, const std::vector<Point3>& actual,
                        const std::vector<LocalScale>& scales);

/// The student's vertex for each vertex of the level. Of the ways in which the two surfaces
/// fit together (a symmetric mesh has many), one by which few positions are wrong: none, if
/// there is such a way. Those with the old numbers come first.
/// @param old_to_mine  the student's vertex for each vertex of the mesh before the step
/// @param scales       how far each vertex of the level may be off
/// @return empty if the triangles are joined in another way
std::vector<Ref> match_level(const Level& level, const std::vector<Ref>& old_to_mine,
                             const MeshDump& mesh, const std::vector<LocalScale>& scales);

/// The positions in `mesh` of the vertices of a level.
std::vector<Point3> matched_points(const std::vector<Ref>& match, const MeshDump& mesh);

}  // namespace meshgrade
