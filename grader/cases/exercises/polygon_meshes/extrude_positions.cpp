#include "grader/cases/placement_cases.h"

namespace meshgrade {
namespace {

/// A move of about the size, in any direction; from a third larger to nearly a point.
Placement draw_extrusion(const PlacementInput& /*face*/, double size, Random& random) {
  Placement placement;
  for (double& x : placement.vector)
    x = random.between(-size, size);
  placement.amount = random.between(-0.3, 0.9);
  return placement;
}

}  // namespace

void make_extrude_positions_cases(CaseMaker& maker) {
  make_placement_cases(
      maker, {"PolyMesh::placeExtruded", {"face_extrude"}, "extruded", draw_extrusion});
}

void shrink_extrude_positions_case(CaseMaker& /*maker*/, const Case& /*failed*/) {}

}  // namespace meshgrade
