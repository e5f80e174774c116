#pragma once

#include <string>
#include <vector>

#include "grader/judge/deviation.h"
#include "grader/mesh/mesh_dump.h"
#include "grader/view/picture_request.h"

namespace meshgrade {

/// A mesh of a picture, with what is written above it; empty: nothing.
struct PicturePanel {
  std::string caption;
  const MeshDump& mesh;
  const Deviation& deviation;
  /// The student's normals of the vertices by their numbers, not finite where there is none;
  /// empty: none are asked for.
  std::vector<Point3> normals = {};
};

/// Draws meshes beside each other without perspective, the far faces first. Broken meshes are
/// drawn too: the faces that close, and every edge whose two ends are known.
/// @param title, description  what the picture is of, for those who do not see it
std::string picture_svg(const std::vector<PicturePanel>& panels, const PictureRequest& request,
                        const std::string& title, const std::string& description);

}  // namespace meshgrade
