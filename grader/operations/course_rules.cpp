#include "grader/operations/course_rules.h"

#include <algorithm>
#include <set>
#include <utility>

namespace meshgrade {
namespace {

bool touches_boundary(const Surface& surface, const Picked& picked) {
  return std::any_of(picked.corners.begin(), picked.corners.end(),
                     [&](Label corner) { return surface.is_boundary(corner); });
}

/// Whether only triangles lie beside an edge.
bool is_between_triangles(const FaceLists& before, const Surface& surface, Label a, Label b) {
  const auto is_other = [&](const std::optional<std::size_t>& face) {
    return face && before.faces[*face].size() != 3;
  };
  return !is_other(surface.face_with_side(a, b)) && !is_other(surface.face_with_side(b, a));
}

Answer leave_open(Answer answer, std::string reason) {
  answer.demand = Demand::kOpen;
  answer.reason = std::move(reason);
  return answer;
}

/// That all faces at a vertex become one may well be taken to mean the outside, too.
Answer as_asked_until_2022(const LocalOperation& operation, const FaceLists& before,
                           const Picked& picked, Answer answer) {
  static const std::set<std::string> change_boundaries{
      "edge_collapse", "edge_dissolve", "face_collapse", "vertex_bevel", "edge_bevel"};
  const char* no_rule = "it lies at a boundary, for which the course had no rule";
  const Surface surface(before);
  if (operation.exercise == "edge_split_polygon") {
    const Corners& ends = picked.corners;
    if (is_between_triangles(before, surface, ends[0], ends[1])) return answer;
    return allow(std::move(answer), "the course splits edges of triangles only");
  }
  if (!touches_boundary(surface, picked)) return answer;
  if (operation.exercise == "vertex_dissolve") return leave_open(std::move(answer), no_rule);
  if (change_boundaries.count(operation.exercise) == 0) return answer;
  return allow(std::move(answer), no_rule);
}

}  // namespace

std::vector<std::string> rules_choices() {
  return {"all", "scotty3d-2020"};
}

Answer as_asked(CourseRules rules, const LocalOperation& operation, const FaceLists& before,
                const Picked& picked, Answer answer) {
  if (rules == CourseRules::kAll || answer.demand == Demand::kRefuse) return answer;
  return as_asked_until_2022(operation, before, picked, std::move(answer));
}

}  // namespace meshgrade
