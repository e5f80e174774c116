#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

Answer face_extrude_answer(const FaceLists& before, const Picked& picked) {
  const Corners& face = picked.corners;
  Answer answer;
  answer.first_free = static_cast<Label>(before.positions.size());
  answer.after = before;
  Corners copy;
  for (Label corner : face)
    copy.push_back(answer.after.add(before.positions[corner]));
  std::vector<Corners> faces{copy};
  for (std::size_t i = 0; i < face.size(); ++i) {
    const std::size_t next = (i + 1) % face.size();
    faces.push_back({face[i], face[next], copy[next], copy[i]});
  }
  answer.after.replace(face, faces);
  answer.returned = {copy};
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
