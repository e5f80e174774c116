#include "grader/operations/cut_corners.h"

#include <map>
#include <utility>

namespace meshgrade {
namespace {

class CornerCut {
 public:
  CornerCut(const FaceLists& before, const Corners& vertices)
      : before_(before), surface_(before), vertices_(vertices) {
    answer_.first_free = static_cast<Label>(before.positions.size());
    answer_.after.positions = before.positions;
  }

  Answer run() {
    for (Label v : vertices_) {
      for (Label outer : surface_.neighbours(v)) {
        if (!is_cut(outer)) ends_[{v, outer}] = answer_.after.add(before_.positions[v]);
      }
    }
    for (const Corners& face : before_.faces)
      answer_.after.faces.push_back(with_cuts(face));
    for (Label v : vertices_)
      close_at_boundary(v);
    const Corners face = round_of(next_);
    answer_.after.faces.push_back(face);
    answer_.returned = {face};
    return std::move(answer_);
  }

 private:
  bool is_cut(Label corner) const { return place_of(vertices_, corner).has_value(); }

  /// The face with the new ends of the edges that leave it, in place of each vertex that is
  /// cut.
  Corners with_cuts(const Corners& face) {
    Corners now;
    const std::size_t n = face.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Label corner = face[i];
      const Label before = face[(i + n - 1) % n];
      const Label after = face[(i + 1) % n];
      if (!is_cut(corner)) {
        now.push_back(corner);
        continue;
      }
      if (!is_cut(before)) now.push_back(ends_.at({corner, before}));
      if (!is_cut(after)) {
        const Label end = ends_.at({corner, after});
        // From where the face comes to the cut: here, or at the other end of the edge.
        const Label start = !is_cut(before) ? now.back() : start_of_edge(face, before);
        next_[end] = start;
        now.push_back(end);
      }
    }
    return now;
  }

  /// The new end at the other vertex that is cut, of the edge by which a face comes to it.
  Label start_of_edge(const Corners& face, Label first) const {
    const Corners turned = beginning_with(face, first);
    return ends_.at({first, turned.back()});
  }

  void close_at_boundary(Label v) {
    if (!surface_.is_boundary(v)) return;
    Label in = v;   // the boundary loop comes from there,
    Label out = v;  // and leads there
    for (Label outer : surface_.neighbours(v)) {
      if (surface_.is_outside(outer, v)) in = outer;
      if (surface_.is_outside(v, outer)) out = outer;
    }
    next_[ends_.at({v, out})] = ends_.at({v, in});
  }

  const FaceLists& before_;
  Surface surface_;
  const Corners& vertices_;
  std::map<std::pair<Label, Label>, Label> ends_;  ///< of (vertex, neighbour)
  std::map<Label, Label> next_;                    ///< around the new face
  Answer answer_;
};

}  // namespace

Answer cut_corners(const FaceLists& before, const Corners& vertices) {
  return CornerCut(before, vertices).run();
}

}  // namespace meshgrade
