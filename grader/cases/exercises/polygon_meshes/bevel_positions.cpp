#include <algorithm>
#include <cmath>

#include "grader/cases/placement_cases.h"

namespace meshgrade {
namespace {

/// How much of a unit direction is along an edge, at least: an edge across it leads nowhere.
constexpr double kLeastAlong = 0.25;

double least_along(const PlacementInput& face, const Point3& direction) {
  double least = 1.0;
  for (const RingCorner& corner : ring_of(face.mesh, face.face)) {
    const Point3& at = face.mesh.positions[corner.corner];
    const Point3& outer = face.mesh.positions[corner.outer];
    const Point3 way{outer[0] - at[0], outer[1] - at[1], outer[2] - at[2]};
    const double length = std::hypot(way[0], way[1], way[2]);
    const double dot = way[0] * direction[0] + way[1] * direction[1] + way[2] * direction[2];
    least = std::min(least, std::abs(dot) / length);
  }
  return least;
}

/// Any direction that is not across an edge of the ring, and not more of the way than would
/// lead an eighth of the shortest edge along one of them.
Placement draw_bevel(const PlacementInput& face, double size, Random& random) {
  Placement best;
  double most = -1.0;
  for (int tries = 0; tries < 200 && most < kLeastAlong; ++tries) {
    Point3 direction;
    for (double& x : direction)
      x = random.between(-1.0, 1.0);
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    for (double& x : direction)
      x /= length;
    const double along = least_along(face, direction);
    if (along <= most) continue;
    most = along;
    best.vector = direction;
  }
  best.amount = random.between(0.02, 0.12) * size * std::min(1.0, most);
  return best;
}

}  // namespace

void make_bevel_positions_cases(CaseMaker& maker) {
  make_placement_cases(
      maker,
      {"PolyMesh::placeBevelled", {"vertex_bevel", "edge_bevel"}, "bevelled", draw_bevel});
}

void shrink_bevel_positions_case(CaseMaker& /*maker*/, const Case& /*failed*/) {}

}  // namespace meshgrade
