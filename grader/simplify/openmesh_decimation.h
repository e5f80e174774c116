#pragma once

#include <cstddef>
#include <functional>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// Collapses edges of a mesh of triangles by OpenMesh's decimater with quadric errors, each to
/// one of its ends, until at most so many faces are left.
///
/// @param mesh      a manifold whose polygons are triangles
/// @param progress  if set, is called now and then with the number of collapses so far
/// @return a mesh with more faces where OpenMesh has no collapse left that it allows
PolygonMesh openmesh_decimation(const PolygonMesh& mesh, std::size_t faces,
                                const std::function<void(std::size_t)>& progress = nullptr);

}  // namespace meshgrade
