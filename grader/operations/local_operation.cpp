#include "grader/operations/local_operation.h"

#include <utility>

namespace meshgrade {

Answer refuse(const FaceLists& before, std::string reason) {
  Answer answer;
  answer.demand = Demand::kRefuse;
  answer.reason = std::move(reason);
  answer.after = before;
  answer.first_free = static_cast<Label>(before.positions.size());
  return answer;
}

Answer allow(Answer answer, std::string reason) {
  answer.demand = Demand::kEither;
  answer.reason = std::move(reason);
  return answer;
}

Answer without_face(const FaceLists& before, std::size_t face) {
  Answer answer;
  answer.after = before;
  answer.after.faces.erase(answer.after.faces.begin() + static_cast<std::ptrdiff_t>(face));
  answer.first_free = static_cast<Label>(before.positions.size());
  const Corners& corners = before.faces[face];
  const Surface surface(answer.after);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Label a = corners[i];
    const Label b = corners[(i + 1) % corners.size()];
    if (surface.is_outside(a, b)) answer.returned.push_back(surface.loop_of(a, b));
  }
  return answer;
}

Answer settle(Answer answer) {
  if (answer.demand != Demand::kMust) return answer;
  std::string trouble = trouble_of(answer.after);
  if (trouble.empty()) return answer;
  return allow(std::move(answer), "what is left is degenerate: " + trouble);
}

Point3 middle(const FaceLists& lists, const Corners& corners) {
  Point3 sum{0.0, 0.0, 0.0};
  for (Label label : corners) {
    for (std::size_t i = 0; i < 3; ++i)
      sum[i] += lists.positions[label][i];
  }
  for (double& x : sum)
    x /= static_cast<double>(corners.size());
  return sum;
}

}  // namespace meshgrade
