#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

/// f = (a, b, c, ...) loses b and gains d, g = (b, a, d, ...) loses a and gains c.
Answer edge_flip_polygon_answer(const FaceLists& before, const Picked& picked) {
  const Label a = picked.corners[0];
  const Label b = picked.corners[1];
  const Surface surface(before);
  if (surface.is_boundary_edge(a, b)) return refuse(before, "it lies on a boundary");
  const std::size_t f = *surface.face_with_side(a, b);
  const std::size_t g = *surface.face_with_side(b, a);
  Corners of_f = beginning_with(before.faces[f], a);
  Corners of_g = beginning_with(before.faces[g], b);
  const Label c = of_f[2];
  const Label d = of_g[2];
  if (place_of(of_f, d) || place_of(of_g, c))
    return refuse(before, "a face would visit one of its new ends twice");
  of_f[1] = d;
  of_g[1] = c;
  Answer answer;
  answer.after = before;
  answer.after.faces[f] = of_f;
  answer.after.faces[g] = of_g;
  answer.first_free = static_cast<Label>(before.positions.size());
  answer.returned = {Corners{c, d}};
  return settle(std::move(answer));
}

}  // namespace

LocalOperation edge_flip_polygon_operation() {
  return {"edge_flip_polygon",
          "PolyMesh::flipEdge",
          "flip",
          ElementKind::kEdge,
          ElementKind::kEdge,
          edge_flip_polygon_answer,
          "a flip creates and deletes nothing"};
}

}  // namespace meshgrade
