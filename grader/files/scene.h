#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// An affine map of space: the upper three rows of a 4 x 4 matrix that acts on columns.
struct Transform {
  std::array<std::array<double, 4>, 3> rows = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  Point3 operator()(const Point3& point) const;
  /// Whether it turns the inside out.
  bool is_mirror() const;
};

/// First `inner`, then `outer`.
Transform operator*(const Transform& outer, const Transform& inner);

Transform translation(const Point3& by);
Transform scaling(const Point3& by);
/// Right-handed, around an axis of any length but zero.
Transform rotation(const Point3& axis, double radians);
/// From a quaternion x, y, z, w of any length but zero.
Transform rotation(const std::array<double, 4>& quaternion);

/// Adds a transformed copy of `part` to `whole`. A mirrored copy gets its polygons reversed, so
/// that they stay counter-clockwise seen from outside. Throws UserError at `place` if a
/// position becomes infinite or the whole grows beyond 20 million corners, which only a scene
/// does that puts its parts in again and again.
void append_part(PolygonMesh& whole, const PolygonMesh& part, const Transform& transform,
                 const std::filesystem::path& file, const std::string& place);

}  // namespace meshgrade
