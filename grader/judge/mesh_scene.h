#pragma once

#include <string>
#include <vector>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/mesh_rules.h"

namespace meshgrade {

/// A mesh before a step, as the student's code left it, and as it must be: what a viewer shows.
/// Only for a step that went wrong, and only where the meshes are small; else empty.
struct MeshScene {
  std::string step;      ///< "flip e5 (v0-v3)"
  Ref edge = kUnsetRef;  ///< the edge that it was about, if it was one
  MeshDump before;
  MeshDump yours;
  MeshDump expected;
  FaceShape faces = FaceShape::kTriangles;  ///< what the rules are checked for

  bool empty() const { return yours.halfedges.empty(); }
};

/// Larger meshes are not kept for a picture: there is one for each case that is explained.
constexpr std::size_t kMostSceneHalfedges = 4000;

}  // namespace meshgrade
