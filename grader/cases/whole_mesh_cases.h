#pragma once

#include <cstdint>
#include <string>

#include "grader/cases/case_list.h"

namespace meshgrade {

/// What an exercise asks whose function works on a whole mesh.
struct WholeMeshExercise {
  std::string function;  ///< "PolyMesh::triangulate"
  /// "triangulate quad_cube.dae", from how often the function is called and the mesh
  std::string (*title)(std::uint32_t times, const std::string& mesh);
  std::uint32_t most_times = 1;  ///< calls on small meshes, each on what came of the one before
  /// Handle uses that a good solution never needs for a corner of a face.
  std::uint64_t steps_per_corner = 400;
  /// Whether it must be done on a mesh; nullptr if always. Else it is asked once, in the group
  /// `refused`.
  bool (*takes)(const PolygonMesh& mesh) = nullptr;
};

/// Adds cases on meshes of polygons, in the groups
///
///   basic     closed meshes, one call
///   levels    the same with up to most_times calls
///   boundary  meshes with boundaries
///   stress    other anchors; tiny, huge, distant, turned and mirrored meshes; faces and
///             vertices with up to 24 edges; several components; 10,000 quads
void make_whole_mesh_cases(CaseMaker& maker, const WholeMeshExercise& exercise);

/// Adds smaller questions than one that failed: fewer calls, then smaller meshes of its kind.
void shrink_whole_mesh_case(CaseMaker& maker, const WholeMeshExercise& exercise,
                            const Case& failed);

}  // namespace meshgrade
