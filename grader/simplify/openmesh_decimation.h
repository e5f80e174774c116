#pragma once

#include <cstddef>
#include <functional>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// Collapses edges of a mesh of triangles by OpenMesh's decimater with quadric errors, each to
/// one of its ends, until at most so many faces are left. Where the surface is flat, nothing
/// keeps its outline or keeps triangles from lying on each other.
///
/// @param mesh  a manifold whose polygons are triangles
/// @return a mesh with more faces where OpenMesh has no collapse left that it allows
PolygonMesh openmesh_decimation(const PolygonMesh& mesh, std::size_t faces);

/// The same, but boundaries stay where they are, and no triangle is turned by 80 degrees or
/// more.
///
/// @param progress  if set, is called now and then with the number of collapses so far
PolygonMesh outline_keeping_decimation(
    const PolygonMesh& mesh, std::size_t faces,
    const std::function<void(std::size_t)>& progress = nullptr);

}  // namespace meshgrade
