#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

Answer vertex_inset_answer(const FaceLists& before, const Picked& picked) {
  Answer answer;
  answer.first_free = static_cast<Label>(before.positions.size());
  answer.after.positions = before.positions;
  const Label m = answer.after.add(middle(before, picked.corners));
  const Corners face = canonical(picked.corners);
  for (const Corners& corners : before.faces) {
    if (canonical(corners) != face) {
      answer.after.faces.push_back(corners);
      continue;
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
      answer.after.faces.push_back({corners[i], corners[(i + 1) % corners.size()], m});
  }
  answer.returned = {m};
  return settle(std::move(answer));
}

}  // namespace

LocalOperation vertex_inset_operation() {
  return {"vertex_inset",
          "PolyMesh::insetVertex",
          "inset a vertex into",
          ElementKind::kFace,
          ElementKind::kVertex,
          vertex_inset_answer,
          "one vertex more, an edge for each corner, and a face less than that"};
}

}  // namespace meshgrade
