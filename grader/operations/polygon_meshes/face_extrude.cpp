#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

Answer face_extrude_answer(const FaceLists& before, const Picked& picked) {
  Answer answer;
  answer.first_free = static_cast<Label>(before.positions.size());
  answer.after.positions = before.positions;
  const Corners face = canonical(picked.corners);
  for (const Corners& corners : before.faces) {
    if (canonical(corners) != face) {
      answer.after.faces.push_back(corners);
      continue;
    }
    Corners copy;
    for (Label corner : corners)
      copy.push_back(answer.after.add(before.positions[corner]));
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      answer.after.faces.push_back({corners[i], corners[next], copy[next], copy[i]});
    }
    answer.after.faces.push_back(copy);
    answer.returned = copy;
  }
  return settle(std::move(answer));
}

}  // namespace

LocalOperation face_extrude_operation() {
  return {"face_extrude",
          "PolyMesh::extrudeFace",
          "extrude",
          ElementKind::kFace,
          ElementKind::kFace,
          face_extrude_answer,
          "a vertex, two edges and a face more for each corner"};
}

}  // namespace meshgrade
