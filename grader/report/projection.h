#pragma once

// How a mesh is drawn without perspective: one direction to look from, the far parts first.

#include <array>
#include <cstddef>
#include <vector>

#include "grader/mesh/polygon_mesh.h"
#include "grader/report/svg_pen.h"
#include "meshedit/vector3d.h"

namespace meshgrade {

meshedit::Vector3D vector_of(const Point3& p);
bool is_finite(const meshedit::Vector3D& v);

/// Looks at a mesh from far away.
class Projection {
 public:
  /// @param towards  the direction from the mesh to the eye, of length 1
  /// @param up       what is up in the picture; not along `towards`
  Projection(const meshedit::Vector3D& towards, const meshedit::Vector3D& up);

  /// Where a point is seen, in the units of the mesh; y down.
  Spot on_screen(const Point3& p) const;
  /// Larger is nearer to the eye.
  double depth(const Point3& p) const;
  /// How much a triangle that is wound counter-clockwise faces the eye: 1 fully, 0 seen from
  /// its edge, below 0 from behind. 0 if it has no area.
  double facing(const Point3& a, const Point3& b, const Point3& c) const;
  const meshedit::Vector3D& towards() const { return towards_; }

 private:
  meshedit::Vector3D towards_;
  meshedit::Vector3D right_;
  meshedit::Vector3D up_;
};

/// The indices of the depths, the farthest first: the painter's order.
std::vector<std::size_t> far_to_near(const std::vector<double>& depths);

}  // namespace meshgrade
