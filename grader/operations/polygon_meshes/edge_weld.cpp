#include <algorithm>

#include "grader/operations/local_operation.h"

namespace meshgrade {
namespace {

/// An edge with one face: the side from `start` to `end` is that of the face.
struct BoundaryEdge {
  Label start;
  Label end;
};

BoundaryEdge boundary_edge(const Surface& surface, const Corners& ends) {
  if (surface.is_outside(ends[0], ends[1])) return {ends[1], ends[0]};
  return {ends[0], ends[1]};
}

bool share_a_face(const FaceLists& before, const Surface& surface, Label a, Label b) {
  const std::span<const std::size_t> faces = surface.faces_at(a);
  return std::any_of(faces.begin(), faces.end(),
                     [&](std::size_t f) { return place_of(before.faces[f], b).has_value(); });
}

/// Of two ends that become one: whether another edge leads from both to the same vertex.
bool share_a_neighbour(const Surface& surface, Label a, Label b, Label other_a, Label other_b) {
  const std::span<const Label> of_a = surface.neighbours(a);
  return std::any_of(of_a.begin(), of_a.end(), [&](Label x) {
    const bool is_the_weld = x == other_a && x == other_b;
    return !is_the_weld && surface.are_neighbours(b, x);
  });
}

/// What keeps two ends from becoming one vertex; empty if nothing does.
std::string trouble_of_ends(const FaceLists& before, const Surface& surface, Label a, Label b) {
  if (a == b) return {};
  if (surface.is_edge(a, b)) return "an edge joins two of their ends that would become one";
  if (share_a_face(before, surface, a, b))
    return "a face has two of their ends that would become one";
  return {};
}

/// One vertex of two, in the middle; of one and the same it stays that.
Label join_ends(FaceLists& lists, Label a, Label b) {
  if (a == b) return a;
  const auto left = lists.add(middle(lists, {a, b}));
  for (Corners& face : lists.faces) {
    for (Label& corner : face)
      corner = corner == a || corner == b ? left : corner;
  }
  return left;
}

Answer edge_weld_answer(const FaceLists& before, const Picked& picked) {
  const Surface surface(before);
  const Corners& first = picked.corners;
  const Corners& second = picked.partner;
  if (std::is_permutation(first.begin(), first.end(), second.begin(), second.end()))
    return refuse(before, "they are the same edge");
  if (!surface.is_boundary_edge(first[0], first[1]) ||
      !surface.is_boundary_edge(second[0], second[1]))
    return refuse(before, "one of them has a face on both sides");
  const BoundaryEdge e = boundary_edge(surface, first);
  const BoundaryEdge f = boundary_edge(surface, second);
  for (const auto& [one, other] : {std::pair(e.start, f.end), std::pair(e.end, f.start)}) {
    const std::string trouble = trouble_of_ends(before, surface, one, other);
    if (!trouble.empty()) return refuse(before, trouble);
  }
  Answer answer;
  answer.first_free = static_cast<Label>(before.positions.size());
  answer.after = before;
  const Label start = join_ends(answer.after, e.start, f.end);
  const Label end = join_ends(answer.after, e.end, f.start);
  answer.returned = {Corners{start, end}};
  const bool doubles =
      (e.start != f.end && share_a_neighbour(surface, e.start, f.end, e.end, f.start)) ||
      (e.end != f.start && share_a_neighbour(surface, e.end, f.start, e.start, f.end));
  if (doubles) return allow(std::move(answer), "two edges would join the same vertices");
  return settle(std::move(answer));
}

}  // namespace

LocalOperation edge_weld_operation() {
  LocalOperation operation{
      "edge_weld",
      "PolyMesh::weldEdges",
      "weld",
      ElementKind::kEdge,
      ElementKind::kEdge,
      edge_weld_answer,
      "of two edges one is left, and of each two ends that meet one vertex; a vertex that both "
      "edges have stays; one boundary loop may become two, two become one, and none is left of "
      "two edges"};
  operation.picks_two = true;
  return operation;
}

}  // namespace meshgrade
