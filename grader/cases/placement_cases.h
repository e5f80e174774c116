#pragma once

#include <string>
#include <vector>

#include "grader/base/random.h"
#include "grader/cases/case_list.h"
#include "grader/cases/placement_input.h"

namespace meshgrade {

/// What an exercise asks that places the corners of a face.
struct PlacementExercise {
  std::string function;                 ///< "PolyMesh::placeExtruded"
  std::vector<std::string> operations;  ///< what makes the faces: "face_extrude"
  std::string done;                     ///< "extruded"
  /// A call that makes sense for a face, of at most this size.
  Placement (*draw)(const PlacementInput& face, double size, Random& random) = nullptr;
};

/// A corner of a face, and the vertex outside of it that an edge joins it to, by their numbers.
struct RingCorner {
  std::uint32_t corner;
  std::uint32_t outer;
};

/// All corners of a face, in its order. Each has one edge that is no side.
std::vector<RingCorner> ring_of(const PolygonMesh& mesh, std::uint32_t face);

/// Adds cases on faces that operations have made on meshes of polygons, in the groups
///
///   basic   one call
///   again   the same call twice, and series of calls
///   stress  other anchors; tiny, huge, distant, turned and mirrored meshes
void make_placement_cases(CaseMaker& maker, const PlacementExercise& exercise);

}  // namespace meshgrade
