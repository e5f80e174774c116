#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

Answer vertex_inset_answer(const FaceLists& before, const Picked& picked) {
  const Corners& face = picked.corners;
  Answer answer;
  answer.first_free = static_cast<Label>(before.positions.size());
  answer.after = before;
  const Label m = answer.after.add(middle(before, face));
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < face.size(); ++i)
    triangles.push_back({face[i], face[(i + 1) % face.size()], m});
  answer.after.replace(face, triangles);
  answer.returned = {Corners{m}};
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
