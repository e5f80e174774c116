#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

/// Both ends become `left`; of a face with both, one corner goes, and of a triangle nothing
/// stays.
FaceLists merge(const FaceLists& before, Label a, Label b, Label left) {
  FaceLists after;
  after.positions = before.positions;
  for (const Corners& corners : before.faces) {
    Corners merged;
    for (Label corner : corners) {
      const Label now = corner == a || corner == b ? left : corner;
      if (merged.empty() || merged.back() != now) merged.push_back(now);
    }
    if (merged.size() > 1 && merged.front() == merged.back()) merged.pop_back();
    if (merged.size() >= 3) after.faces.push_back(std::move(merged));
  }
  return after;
}

/// What makes a collapse leave no surface; empty if nothing does.
std::string trouble(const FaceLists& before, const Surface& surface, Label a, Label b) {
  if (surface.is_boundary(a) && surface.is_boundary(b) && !surface.is_boundary_edge(a, b))
    return "both of its ends lie on a boundary, and the edge itself does not";
  for (std::size_t f : surface.faces_at(a)) {
    const Corners turned = beginning_with(before.faces[f], a);
    if (!place_of(turned, b)) continue;
    const bool beside = turned[1] == b || turned.back() == b;
    if (!beside) return "another face than those beside it has both of its ends";
    if (turned.size() != 3) continue;
    const Label c = turned[1] == b ? turned[2] : turned[1];
    if (surface.neighbours(c).size() < 3)
      return "the third corner of a triangle beside it would have one edge only";
  }
  return {};
}

/// Whether a and b have a neighbour in common that is no corner of a triangle beside the edge.
bool have_another_neighbour(const FaceLists& before, const Surface& surface, Label a, Label b) {
  for (Label c : surface.neighbours(a)) {
    if (surface.neighbours(b).count(c) == 0) continue;
    bool is_apex = false;
    for (std::size_t f : surface.faces_at(c)) {
      const Corners& corners = before.faces[f];
      is_apex =
          is_apex || (corners.size() == 3 && place_of(corners, a) && place_of(corners, b));
    }
    if (!is_apex) return true;
  }
  return false;
}

Answer edge_collapse_answer(const FaceLists& before, const Picked& picked) {
  const Label a = picked.corners[0];
  const Label b = picked.corners[1];
  const Surface surface(before);
  const std::string reason = trouble(before, surface, a, b);
  if (!reason.empty()) return refuse(before, reason);
  Answer answer;
  const auto left = static_cast<Label>(before.positions.size());
  answer.after = merge(before, a, b, left);
  answer.after.positions.push_back(middle(before, picked.corners));
  if (answer.after.faces.empty()) return refuse(before, "nothing would be left");
  answer.first_free = left;
  answer.returned = {left};
  if (surface.is_boundary_edge(a, b)) {
    const bool inside_is_ab = surface.face_with_side(a, b).has_value();
    const std::size_t edges =
        inside_is_ab ? surface.loop_length(b, a) : surface.loop_length(a, b);
    if (edges == 3)
      return allow(std::move(answer), "its boundary has three edges and would have two");
  }
  if (have_another_neighbour(before, surface, a, b))
    return allow(std::move(answer), "two edges would join the same vertices");
  return settle(std::move(answer));
}

}  // namespace

LocalOperation edge_collapse_operation() {
  return {
      "edge_collapse",
      "PolyMesh::collapseEdge",
      "collapse",
      ElementKind::kEdge,
      ElementKind::kVertex,
      edge_collapse_answer,
      "one vertex and one edge go; with each triangle beside the edge one edge and one face "
      "more"};
}

}  // namespace meshgrade
