#include "grader/operations/cut_corners.h"

namespace meshgrade {
namespace {

Answer edge_bevel_answer(const FaceLists& before, const Picked& picked) {
  const Label a = picked.corners[0];
  const Label b = picked.corners[1];
  const Surface surface(before);
  if (surface.is_boundary_edge(a, b)) return refuse(before, "it lies on a boundary");
  const std::size_t at_a = surface.neighbours(a).size();
  const std::size_t at_b = surface.neighbours(b).size();
  if (at_a + at_b - 2 < 3)
    return refuse(before,
                  "its ends have two edges each, and the new face would have two corners");
  Answer answer = cut_corners(before, picked.corners);
  if (at_a == 2 || at_b == 2)
    return allow(std::move(answer), "one of its ends has two edges only");
  return settle(std::move(answer));
}

}  // namespace

LocalOperation edge_bevel_operation() {
  return {"edge_bevel",
          "PolyMesh::bevelEdge",
          "bevel",
          ElementKind::kEdge,
          ElementKind::kFace,
          edge_bevel_answer,
          "a corner and a side of the new face for each other edge at its ends; the edge and "
          "both ends go"};
}

}  // namespace meshgrade
