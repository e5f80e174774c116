#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

Answer face_remove_answer(const FaceLists& before, const Picked& picked) {
  const Corners& face = picked.corners;
  const Surface surface(before);
  const std::size_t n = face.size();
  std::size_t boundary_sides = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool comes_along = surface.is_boundary_edge(face[(i + n - 1) % n], face[i]);
    const bool leaves_along = surface.is_boundary_edge(face[i], face[(i + 1) % n]);
    boundary_sides += leaves_along ? 1 : 0;
    if (surface.is_boundary(face[i]) && !comes_along && !leaves_along)
      return refuse(before, "it touches a boundary in a corner, and not in a side there");
  }
  if (boundary_sides == n) return refuse(before, "all of its sides lie on a boundary");
  return settle(without_face(before, *surface.face_with_side(face[0], face[1])));
}

}  // namespace

LocalOperation face_remove_operation() {
  return {"face_remove",
          "PolyMesh::removeFace",
          "remove",
          ElementKind::kFace,
          ElementKind::kFace,
          face_remove_answer,
          "the face goes, and each side that lay on a boundary; so does a corner between two "
          "of these; boundary loops may join, or fall apart"};
}

}  // namespace meshgrade
