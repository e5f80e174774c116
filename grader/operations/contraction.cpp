#include "grader/operations/contraction.h"

#include <algorithm>

namespace meshgrade {
namespace {

class Contraction {
 public:
  Contraction(const FaceLists& before, const Corners& corners)
      : before_(before), surface_(before), corners_(corners) {
    for (const Corners& face : before.faces) {
      Label outer = 0;
      std::size_t outer_corners = 0;
      for (Label corner : face) {
        if (place_of(corners, corner)) continue;
        outer = corner;
        ++outer_corners;
      }
      if (outer_corners == 1) ++vanishing_[outer];
    }
  }

  const Surface& surface() const { return surface_; }

  /// In how many places its round meets the boundary; 0 also if all of it is boundary.
  std::size_t boundary_places() const {
    const auto corners = std::count_if(corners_.begin(), corners_.end(), [&](Label corner) {
      return surface_.is_boundary(corner);
    });
    return static_cast<std::size_t>(corners) - boundary_sides();
  }

  /// How many boundary edges are contracted.
  std::size_t boundary_sides() const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < side_count(); ++i) {
      if (surface_.is_boundary_edge(corners_[i], end_of_side(i))) ++n;
    }
    return n;
  }

  /// Whether a face visits the new vertex twice.
  bool is_visited_twice() const {
    return std::any_of(before_.faces.begin(), before_.faces.end(),
                       [&](const Corners& face) { return visits_twice(face); });
  }

  /// A vertex beside what vanishes that keeps one edge, or none.
  bool leaves_one_edge() const {
    return std::any_of(vanishing_.begin(), vanishing_.end(), [&](const auto& at) {
      return surface_.neighbours(at.first).size() - at.second < 2;
    });
  }

  /// Whether two edges would join the new vertex to the same one.
  bool doubles_an_edge() const {
    std::map<Label, std::size_t> edges;
    for (Label corner : corners_) {
      for (Label neighbour : surface_.neighbours(corner)) {
        if (!place_of(corners_, neighbour)) ++edges[neighbour];
      }
    }
    return std::any_of(edges.begin(), edges.end(), [&](const auto& at) {
      const auto vanishing = vanishing_.find(at.first);
      return at.second - (vanishing == vanishing_.end() ? 0 : vanishing->second) > 1;
    });
  }

  /// Whether the boundary loop that it touches would have two edges.
  bool leaves_two_boundary_edges() const {
    for (std::size_t i = 0; i < side_count(); ++i) {
      const Label a = corners_[i];
      const Label b = end_of_side(i);
      if (!surface_.is_boundary_edge(a, b)) continue;
      const std::size_t edges = surface_.is_outside(a, b) ? surface_.loop_of(a, b).size()
                                                          : surface_.loop_of(b, a).size();
      return edges - boundary_sides() == 2;
    }
    return false;
  }

 private:
  std::size_t side_count() const { return corners_.size() == 2 ? 1 : corners_.size(); }
  Label end_of_side(std::size_t i) const { return corners_[(i + 1) % corners_.size()]; }

  bool is_side(Label a, Label b) const {
    const std::size_t n = corners_.size();
    const std::size_t i = *place_of(corners_, a);
    return corners_[(i + 1) % n] == b || corners_[(i + n - 1) % n] == b;
  }

  /// A face that consists of the corners is what is contracted, or covers it.
  bool visits_twice(const Corners& face) const {
    std::size_t visits = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Label a = face[i];
      const Label b = face[(i + 1) % face.size()];
      if (!place_of(corners_, a)) continue;
      if (!place_of(corners_, b)) {
        ++visits;
      } else if (!is_side(a, b)) {
        return true;
      }
    }
    return visits > 1;
  }

  const FaceLists& before_;
  Surface surface_;
  const Corners& corners_;
  /// How many faces vanish at each vertex that is their only other corner.
  std::map<Label, std::size_t> vanishing_;
};

bool is_in_use(const FaceLists& lists, Label label) {
  return std::any_of(lists.faces.begin(), lists.faces.end(),
                     [&](const Corners& face) { return place_of(face, label).has_value(); });
}

}  // namespace

Answer contract(const FaceLists& before, const Corners& corners,
                const ContractionReasons& reasons) {
  const Contraction contraction(before, corners);
  const auto left = static_cast<Label>(before.positions.size());
  Answer answer;
  answer.after = merged(before, corners, left);
  answer.after.positions.push_back(middle(before, corners));
  answer.first_free = left;
  answer.returned = {Corners{left}};
  if (answer.after.faces.empty()) return refuse(before, "nothing would be left");
  if (contraction.boundary_places() > 1) return refuse(before, reasons.boundary);
  if (contraction.is_visited_twice()) return refuse(before, reasons.other_face);
  if (contraction.leaves_one_edge()) return refuse(before, reasons.third_corner);
  if (!is_in_use(answer.after, left))
    return refuse(before, "nothing would be left of this part of the mesh");
  if (contraction.leaves_two_boundary_edges())
    return allow(std::move(answer), "its boundary would have two edges only");
  if (contraction.doubles_an_edge())
    return allow(std::move(answer), "two edges would join the same vertices");
  return settle(std::move(answer));
}

}  // namespace meshgrade
