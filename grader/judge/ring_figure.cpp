#include "grader/judge/ring_figure.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace meshgrade {
namespace {

constexpr std::size_t kMostFaces = 40;  ///< that are drawn in a panel
constexpr std::size_t kMostCorners = 64;

/// A face of the student's, by its number.
struct NumberedFace {
  Ref face = kUnsetRef;
  Corners corners;
};

/// The corners of a face; nothing if its half-edges do not lead around it.
Corners walk_around(const MeshDump& mesh, const FaceRecord& face) {
  Corners corners;
  Ref h = face.halfedge;
  do {
    if (h >= mesh.halfedges.size() || corners.size() == kMostCorners) return {};
    const HalfedgeRecord& record = mesh.halfedges[h];
    const bool has_vertex =
        record.vertex < mesh.vertices.size() && mesh.vertices[record.vertex].live != 0;
    if (record.live == 0 || !has_vertex) return {};
    corners.push_back(record.vertex);
    h = record.next;
  } while (h != face.halfedge);
  return corners;
}

std::vector<NumberedFace> faces_of(const MeshDump& mesh) {
  std::vector<NumberedFace> faces;
  for (Ref f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.faces[f].live == 0) continue;
    Corners corners = walk_around(mesh, mesh.faces[f]);
    if (!corners.empty()) faces.push_back({f, std::move(corners)});
  }
  return faces;
}

bool has_any(const Corners& corners, const Corners& wanted) {
  return std::any_of(corners.begin(), corners.end(),
                     [&](Label corner) { return place_of(wanted, corner).has_value(); });
}

/// The vertices on the border of some faces, counter-clockwise.
/// @return nothing if the border is not a single loop that visits each of them once
Corners border_of(const std::vector<NumberedFace>& faces) {
  std::set<std::pair<Label, Label>> sides;
  for (const NumberedFace& face : faces) {
    for (std::size_t i = 0; i < face.corners.size(); ++i)
      sides.insert({face.corners[i], face.corners[(i + 1) % face.corners.size()]});
  }
  std::map<Label, Label> next;
  for (const auto& [a, b] : sides) {
    if (sides.count({b, a}) != 0) continue;
    if (!next.insert({a, b}).second) return {};
  }
  if (next.size() < 3) return {};
  Corners border = round_of(next);
  if (border.size() != next.size()) border.clear();
  return border;
}

std::multiset<Corners> canonical_all(const std::vector<NumberedFace>& faces) {
  std::multiset<Corners> all;
  for (const NumberedFace& face : faces)
    all.insert(canonical(face.corners));
  return all;
}

/// The corners of all faces that have this one.
std::multiset<Label> around(const std::vector<NumberedFace>& faces, Label label) {
  std::multiset<Label> found;
  for (const NumberedFace& face : faces) {
    if (place_of(face.corners, label)) found.insert(face.corners.begin(), face.corners.end());
  }
  return found;
}

/// A free label and a vertex of the student's that may stand for it.
struct Likeness {
  std::size_t common = 0;  ///< corners that their faces have in common
  Label label = 0;
  Label vertex = 0;
};

std::vector<Likeness> likenesses(Label first_free, const std::vector<NumberedFace>& asked,
                                 const std::vector<NumberedFace>& yours) {
  std::set<Label> free;
  std::set<Label> open;
  for (const NumberedFace& face : yours)
    open.insert(face.corners.begin(), face.corners.end());
  for (const NumberedFace& face : asked) {
    for (const Label label : face.corners) {
      if (label >= first_free) {
        free.insert(label);
      } else {
        open.erase(label);
      }
    }
  }
  std::vector<Likeness> all;
  for (const Label label : free) {
    const std::multiset<Label> wanted = around(asked, label);
    for (const Label vertex : open) {
      const std::multiset<Label> there = around(yours, vertex);
      std::vector<Label> common;
      std::set_intersection(wanted.begin(), wanted.end(), there.begin(), there.end(),
                            std::back_inserter(common));
      all.push_back({common.size(), label, vertex});
    }
  }
  return all;
}

/// Which vertex of the student's stands for each free label: those that look most alike.
LabelMap guess_free_labels(Label first_free, const std::vector<NumberedFace>& asked,
                           const std::vector<NumberedFace>& yours) {
  std::vector<Likeness> all = likenesses(first_free, asked, yours);
  std::stable_sort(all.begin(), all.end(),
                   [](const Likeness& a, const Likeness& b) { return a.common > b.common; });
  LabelMap map;
  std::set<Label> taken;
  for (const Likeness& likeness : all) {
    const bool is_open = map.count(likeness.label) == 0 && taken.count(likeness.vertex) == 0;
    if (likeness.common == 0 || !is_open) continue;
    map[likeness.label] = likeness.vertex;
    taken.insert(likeness.vertex);
  }
  return map;
}

class RingPainter {
 public:
  RingPainter(const MeshDump& before, const Picked& picked, const Answer& answer,
              const MeshDump& after)
      : picked_(picked), answer_(answer), yours_(faces_of(after)) {
    Corners corners = picked.corners;
    corners.insert(corners.end(), picked.partner.begin(), picked.partner.end());
    for (const NumberedFace& face : faces_of(before))
      (has_any(face.corners, corners) ? ring_ : outside_).push_back(face);
    leave_out_a_face(corners);
    rim_ = border_of(ring_);
    far_ = canonical_all(outside_);
  }

  RingFigure figure(const std::optional<LabelMap>& known, const std::string& name) {
    RingFigure figure;
    const std::vector<NumberedFace> yours = near(yours_);
    std::vector<NumberedFace> asked;
    for (const Corners& face : answer_.after.faces)
      asked.push_back({kUnsetRef, face});
    asked = near(asked);
    // What has no end of faces is not compared either: that would take its time.
    const std::size_t most = std::max({ring_.size(), yours.size(), asked.size()});
    if (rim_.empty() || most > kMostFaces) return figure;
    const LabelMap free = known ? *known : guess_free_labels(answer_.first_free, asked, yours);
    for (NumberedFace& face : asked)
      face.corners = renamed(std::move(face.corners), free);
    figure.before = panel_of(ring_, canonical_all(ring_));
    figure.yours = panel_of(yours, canonical_all(asked));
    figure.expected = panel_of(asked, canonical_all(yours));
    figure.rim = rim_.size();
    figure.picked = name;
    return figure;
  }

 private:
  /// Where all of a closed mesh is in the ring, a face that has little to do with it is what
  /// the rim lies around.
  void leave_out_a_face(const Corners& picked) {
    if (!outside_.empty() || !border_of(ring_).empty()) return;
    const auto share = [&](const NumberedFace& face) {
      return std::count_if(face.corners.begin(), face.corners.end(),
                           [&](Label corner) { return place_of(picked, corner).has_value(); });
    };
    const auto least = std::min_element(
        ring_.begin(), ring_.end(),
        [&](const NumberedFace& a, const NumberedFace& b) { return share(a) < share(b); });
    if (least == ring_.end()) return;
    outside_.push_back(*least);
    ring_.erase(least);
  }

  Corners renamed(Corners corners, const LabelMap& free) const {
    for (Label& label : corners) {
      const auto found = free.find(label);
      if (found != free.end()) {
        label = found->second;
      } else if (label >= answer_.first_free) {
        label |= kNobody;
      }
    }
    return corners;
  }

  /// All but the faces that lay outside of the ring and are still there.
  std::vector<NumberedFace> near(const std::vector<NumberedFace>& faces) const {
    std::multiset<Corners> far = far_;
    std::vector<NumberedFace> chosen;
    for (const NumberedFace& face : faces) {
      const auto found = far.find(canonical(face.corners));
      if (found != far.end()) {
        far.erase(found);
      } else {
        chosen.push_back(face);
      }
    }
    return chosen;
  }

  /// @param others  faces of which each of these should be one
  RingPanel panel_of(const std::vector<NumberedFace>& faces, std::multiset<Corners> others) {
    RingPanel panel;
    std::map<Label, std::size_t> places;
    for (const NumberedFace& face : faces) {
      RingFace& shown = panel.faces.emplace_back();
      if (face.face != kUnsetRef) shown.name = face_name(face.face);
      for (const Label label : face.corners) {
        const auto [place, is_new] = places.insert({label, panel.vertices.size()});
        if (is_new) panel.vertices.push_back(vertex_of(label));
        shown.corners.push_back(place->second);
      }
      const Corners its = canonical(face.corners);
      shown.is_picked = its == canonical(picked_.corners) || its == partner();
      const auto found = others.find(its);
      shown.differs = found == others.end();
      if (found != others.end()) others.erase(found);
    }
    return panel;
  }

  Corners partner() const {
    return picked_.partner.empty() ? Corners() : canonical(picked_.partner);
  }

  RingVertex vertex_of(Label label) const {
    RingVertex vertex;
    vertex.name = (label & kNobody) != 0 ? "new" : vertex_name(label);
    if (const auto place = place_of(rim_, label)) vertex.rim = *place;
    vertex.is_picked = place_of(picked_.corners, label) || place_of(picked_.partner, label);
    return vertex;
  }

  static constexpr Label kNobody = 1U << 31;  ///< of labels that no vertex stands for

  const Picked& picked_;
  const Answer& answer_;
  std::vector<NumberedFace> yours_;
  std::vector<NumberedFace> ring_;
  std::vector<NumberedFace> outside_;
  Corners rim_;
  std::multiset<Corners> far_;
};

}  // namespace

RingFigure figure_of_ring(const MeshDump& before, const Picked& picked, const Answer& answer,
                          const MeshDump& after, const std::optional<LabelMap>& known,
                          const std::string& name) {
  return RingPainter(before, picked, answer, after).figure(known, name);
}

}  // namespace meshgrade
