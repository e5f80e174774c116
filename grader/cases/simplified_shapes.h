#pragma once

// Meshes of triangles for what makes them coarser.

#include "grader/base/random.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// Each polygon cut from its first corner.
PolygonMesh cut_to_triangles(const PolygonMesh& mesh);

/// Each triangle cut into four at the middles of its sides.
PolygonMesh cut_in_four(const PolygonMesh& triangles);

/// A flat piece of the plane z = x / 2 + y / 4 + 1, from `n` x `n` squares, its corners moved
/// about in it. All coordinates have few bits.
PolygonMesh flat_patch(std::uint32_t n, Random& random);

/// A roof: two flat pieces that meet in a straight ridge.
PolygonMesh roof(std::uint32_t n);

/// A tower with rings of three corners, with one ring so narrow that its edges cost least. None
/// of the edges of inner rings can be collapsed without that two edges get the same ends.
PolygonMesh hourglass();

/// A narrow winding band with `n` squares: both ends of every inner edge lie on the boundary,
/// so that none of them may be collapsed, and they cost less than the others.
PolygonMesh winding_band(std::uint32_t n);

/// Closed shapes with some 1000 triangles: a sphere with bumps, a ring with bumps, a rounded
/// box, a body with a waist, and an ellipsoid whose triangles differ in size. `which` is 0
/// to 4.
PolygonMesh bumpy_shape(std::uint32_t which);
constexpr std::uint32_t kBumpyShapes = 5;
const char* bumpy_shape_name(std::uint32_t which);

}  // namespace meshgrade
