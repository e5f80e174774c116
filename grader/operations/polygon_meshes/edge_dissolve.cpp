#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

/// (a, b, rest of f) and (b, a, rest of g) become (b, rest of f, a, rest of g).
Corners join(const Corners& f, const Corners& g, Label a, Label b) {
  Corners joined = beginning_with(f, b);
  const Corners rest = beginning_with(g, a);
  joined.insert(joined.end(), rest.begin() + 1, rest.end() - 1);
  return joined;
}

Answer dissolve_inside(const FaceLists& before, const Surface& surface, Label a, Label b) {
  const std::size_t f = *surface.face_with_side(a, b);
  const std::size_t g = *surface.face_with_side(b, a);
  if (surface.neighbours(a).size() < 3 || surface.neighbours(b).size() < 3)
    return refuse(before, "one of its ends has no third edge");
  for (Label corner : before.faces[f]) {
    if (corner != a && corner != b && place_of(before.faces[g], corner))
      return refuse(before, "the faces beside it share more than this edge");
  }
  Answer answer;
  answer.after = before;
  answer.after.faces[f] = join(before.faces[f], before.faces[g], a, b);
  answer.returned = {answer.after.faces[f]};
  answer.after.faces.erase(answer.after.faces.begin() + static_cast<std::ptrdiff_t>(g));
  answer.first_free = static_cast<Label>(before.positions.size());
  return settle(std::move(answer));
}

Answer dissolve_at_boundary(const FaceLists& before, const Surface& surface, Label a, Label b) {
  const auto inside = surface.face_with_side(a, b);
  const std::size_t f = inside ? *inside : *surface.face_with_side(b, a);
  for (Label corner : before.faces[f]) {
    if (corner != a && corner != b && surface.is_boundary(corner))
      return refuse(before, "the face beside it touches the boundary elsewhere, too");
  }
  return settle(without_face(before, f));
}

Answer edge_dissolve_answer(const FaceLists& before, const Picked& picked) {
  const Label a = picked.corners[0];
  const Label b = picked.corners[1];
  const Surface surface(before);
  return surface.is_boundary_edge(a, b) ? dissolve_at_boundary(before, surface, a, b)
                                        : dissolve_inside(before, surface, a, b);
}

}  // namespace

LocalOperation edge_dissolve_operation() {
  return {"edge_dissolve",
          "PolyMesh::dissolveEdge",
          "dissolve",
          ElementKind::kEdge,
          ElementKind::kFace,
          edge_dissolve_answer,
          "one edge and one face go, and nothing else"};
}

}  // namespace meshgrade
