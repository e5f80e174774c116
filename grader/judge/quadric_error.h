#pragma once

// The quadric errors of Garland and Heckbert (1997), in double.

#include <array>
#include <optional>

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// The polynomial v^T A v + 2 b . v + c of a point v.
struct Quadric {
  std::array<double, 6> a{};  ///< xx, xy, xz, yy, yz, zz
  Point3 b{};
  double c = 0.0;

  double at(const Point3& v) const;
  /// The sum of the eigenvalues of A.
  double trace() const { return a[0] + a[3] + a[5]; }
};

Quadric operator+(const Quadric& p, const Quadric& q);
Quadric operator*(double factor, const Quadric& q);

/// Twice the area of a triangle, along its normal.
Point3 area_vector(const Point3& p, const Point3& q, const Point3& r);

/// The squared distance from the plane of a triangle; nothing but 0 if it has no area.
Quadric plane_quadric(const Point3& p, const Point3& q, const Point3& r);

/// Where a quadric is least; nothing if A is singular, as far as rounding lets one tell.
std::optional<Point3> least_point(const Quadric& q);

/// Whether A is so far from being singular that no solution may take it to be.
bool has_single_least_point(const Quadric& q);

}  // namespace meshgrade
