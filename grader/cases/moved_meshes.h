#pragma once

// Meshes for which the answer is known from that of another: larger, smaller, elsewhere,
// turned, mirrored. And such with many valences, or with parts of very different size.

#include <string>
#include <vector>

#include "grader/base/random.h"
#include "grader/cases/mesh_shapes.h"

namespace meshgrade {

/// Stretched and shaken like jittered(), to coordinates of few bits: so that they are the same
/// in float, also far from the origin.
PolygonMesh shaken(const PolygonMesh& mesh, Random& random);

/// A mesh under a map, and what to call that.
struct MovedMesh {
  std::string how;  ///< "1,000,000 times smaller"
  PolygonMesh mesh;
  VertexPair edge;  ///< where the edge is that was named
  bool same_size = true;
};

/// A shaken mesh scaled by 1e-6, 1e-2, 10 and 1e6, far from the origin, turned, mirrored (and
/// wound the other way, so that outside stays outside), with the first end of `edge` at the
/// origin, and with the middle of `edge` there. All are in build order, if `mesh` is.
std::vector<MovedMesh> moved_meshes(const PolygonMesh& mesh, VertexPair edge);

/// Double pyramids side by side, shaken: two vertices of each valence from `first` to `last`.
PolygonMesh many_valences(std::uint32_t first, std::uint32_t last, Random& random);

/// A fan of n triangles around a vertex on the boundary, like a winding stair.
PolygonMesh open_fan(std::uint32_t n);

/// A square of n x n smaller ones with a diagonal each, shaken: 2 n n triangles, one boundary.
PolygonMesh open_grid(std::uint32_t n, Random& random);

/// Two meshes as one, that do not touch each other.
PolygonMesh side_by_side(const PolygonMesh& left, const PolygonMesh& right);

/// A shaken mesh within another one that is a thousand times as large.
PolygonMesh two_sizes(const PolygonMesh& small, const PolygonMesh& large, Random& random);

}  // namespace meshgrade
