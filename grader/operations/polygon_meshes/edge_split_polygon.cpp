#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

/// f = (a, b, c, ...) becomes (m, b, c) and (a, m, c, ...).
void cut(FaceLists& lists, std::size_t face, Label a, Label m) {
  Corners rest = beginning_with(lists.faces[face], a);
  lists.faces.push_back({m, rest[1], rest[2]});
  rest[1] = m;
  lists.faces[face] = rest;
}

Answer edge_split_polygon_answer(const FaceLists& before, const Picked& picked) {
  const Label a = picked.corners[0];
  const Label b = picked.corners[1];
  const Surface surface(before);
  Answer answer;
  answer.after = before;
  answer.first_free = static_cast<Label>(before.positions.size());
  const Label m = answer.after.add(middle(before, picked.corners));
  if (const auto f = surface.face_with_side(a, b)) cut(answer.after, *f, a, m);
  if (const auto g = surface.face_with_side(b, a)) cut(answer.after, *g, b, m);
  answer.returned = {Corners{m}};
  answer.anchored_to = {a, b};
  return settle(std::move(answer));
}

}  // namespace

LocalOperation edge_split_polygon_operation() {
  return {"edge_split_polygon",
          "PolyMesh::splitEdge",
          "split",
          ElementKind::kEdge,
          ElementKind::kVertex,
          edge_split_polygon_answer,
          "each face beside the edge is cut in two; outside of the surface nothing is"};
}

}  // namespace meshgrade
