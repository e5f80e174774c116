#include "grader/report/ring_svg.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "grader/report/label_boxes.h"
#include "grader/report/list_column.h"

namespace meshgrade {
namespace {

constexpr double kRingSide = 320.0;
constexpr double kRimRadius = 118.0;
constexpr double kRingMargin = 14.0;
constexpr double kRingTitle = 28.0;
constexpr double kRingLetters = 12.5;
constexpr int kTutteRounds = 300;  ///< of moving to the middle; moves less than a pixel then

/// Counter-clockwise, as one sees it, from the top.
Spot on_rim(std::size_t place, std::size_t rim) {
  const double angle =
      2.0 * std::numbers::pi * static_cast<double>(place) / static_cast<double>(rim);
  return {-kRimRadius * std::sin(angle), -kRimRadius * std::cos(angle)};
}

std::vector<std::set<std::size_t>> neighbours_in(const RingPanel& panel) {
  std::vector<std::set<std::size_t>> neighbours(panel.vertices.size());
  for (const RingFace& face : panel.faces) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const std::size_t a = face.corners[i];
      const std::size_t b = face.corners[(i + 1) % face.corners.size()];
      neighbours[a].insert(b);
      neighbours[b].insert(a);
    }
  }
  return neighbours;
}

/// Where the vertices of a panel are drawn, around its middle.
std::vector<Spot> lay_out(const RingPanel& panel, std::size_t rim) {
  const auto neighbours = neighbours_in(panel);
  std::vector<Spot> spots(panel.vertices.size());
  for (std::size_t v = 0; v < spots.size(); ++v) {
    if (panel.vertices[v].rim != kInsideRim) spots[v] = on_rim(panel.vertices[v].rim, rim);
  }
  for (int round = 0; round < kTutteRounds; ++round) {
    for (std::size_t v = 0; v < spots.size(); ++v) {
      if (panel.vertices[v].rim != kInsideRim) continue;
      Spot sum;
      for (const std::size_t neighbour : neighbours[v])
        sum = sum + spots[neighbour];
      spots[v] = (1.0 / static_cast<double>(neighbours[v].size())) * sum;
    }
  }
  return spots;
}

enum class RingPart { kBefore, kYours, kExpected };

class RingPanelArtist {
 public:
  RingPanelArtist(const SvgPen& pen, const RingPanel& panel, RingPart part, std::size_t rim,
                  const std::string& focus)
      : pen_(pen),
        panel_(panel),
        part_(part),
        focus_(focus),
        spots_(lay_out(panel, rim)),
        labels_(box_around({}, kRingSide, kRingSide)) {}

  void draw() {
    // What differs comes last, so that its outline lies above that of the others.
    for (const bool differs : {false, true}) {
      for (const RingFace& face : panel_.faces) {
        if (face.differs == differs) draw_face(face);
      }
    }
    draw_picked_edge();
    for (std::size_t v = 0; v < spots_.size(); ++v)
      labels_.take(box_around(spots_[v], 9.0, 9.0));
    for (std::size_t v = 0; v < spots_.size(); ++v)
      draw_vertex(v);
    for (const RingFace& face : panel_.faces)
      draw_name(face);
  }

 private:
  const char* color() const { return part_ == RingPart::kYours ? ink::kWrong : ink::kRight; }

  void draw_face(const RingFace& face) const {
    std::vector<Spot> corners;
    for (const std::size_t corner : face.corners)
      corners.push_back(spots_[corner]);
    const bool is_picked = face.is_picked && part_ == RingPart::kBefore;
    const char* fill = face.differs ? (part_ == RingPart::kYours ? "#f7ddd0" : "#d3e4f4")
                       : is_picked  ? "#fbf0c4"
                                    : ink::kFace;
    const Stroke stroke{face.differs ? color() : ink::kEdge, face.differs ? 2.0 : 1.4,
                        face.differs && part_ == RingPart::kExpected ? "6 3" : ""};
    const SvgPen group = pen_.group(face.differs ? "face differs" : "face");
    if (!face.name.empty()) group.tooltip(face.name);
    group.polygon(corners, fill, stroke);
  }

  /// Of an edge that is picked, between its two ends.
  void draw_picked_edge() const {
    std::vector<Spot> ends;
    for (std::size_t v = 0; v < spots_.size(); ++v) {
      if (panel_.vertices[v].is_picked) ends.push_back(spots_[v]);
    }
    const bool has_face = std::any_of(panel_.faces.begin(), panel_.faces.end(),
                                      [](const RingFace& face) { return face.is_picked; });
    if (part_ == RingPart::kBefore && ends.size() == 2 && !has_face)
      pen_.line(ends[0], ends[1], {ink::kText, 3.0});
  }

  void draw_vertex(std::size_t v) {
    const RingVertex& vertex = panel_.vertices[v];
    const bool is_focus = vertex.name == focus_ && part_ == RingPart::kYours;
    const char* its = is_focus ? ink::kWrong : vertex.name == "new" ? ink::kRight : ink::kText;
    pen_.circle(spots_[v], vertex.is_picked || is_focus ? 4.5 : 3.0, its, {});
    const Spot out = length(spots_[v]) > 1.0 ? unit(spots_[v]) : Spot{0.0, -1.0};
    std::vector<Spot> wanted;
    for (const Spot way : {15.0 * out, -15.0 * out, 15.0 * left_of(out), -15.0 * left_of(out)})
      wanted.push_back(spots_[v] + way);
    const Spot place = labels_.place(wanted, text_width(vertex.name, kRingLetters) + 2.0, 14.0);
    pen_.text(place, vertex.name, {kRingLetters, its, is_focus || vertex.is_picked});
  }

  void draw_name(const RingFace& face) {
    if (face.name.empty() || face.corners.empty()) return;
    Spot sum;
    for (const std::size_t corner : face.corners)
      sum = sum + spots_[corner];
    const Spot middle = (1.0 / static_cast<double>(face.corners.size())) * sum;
    const Spot place = labels_.place({middle}, text_width(face.name, kRingLetters) + 2.0, 14.0);
    pen_.text(place, face.name, {kRingLetters, face.differs ? color() : ink::kQuiet, false});
  }

  SvgPen pen_;
  const RingPanel& panel_;
  RingPart part_;
  const std::string& focus_;
  std::vector<Spot> spots_;
  LabelBoxes labels_;
};

void draw_titled(const SvgPen& pen, const RingFigure& figure, RingPart part,
                 const std::string& focus) {
  constexpr const char* kTitles[] = {"before", "yours", "expected"};
  constexpr const char* kColors[] = {ink::kText, ink::kWrong, ink::kRight};
  const auto i = static_cast<std::size_t>(part);
  const RingPanel* panels[] = {&figure.before, &figure.yours, &figure.expected};
  const Spot origin{kRingMargin + (static_cast<double>(i) + 0.5) * kRingSide +
                        static_cast<double>(i) * kRingMargin,
                    kRingTitle + 0.5 * kRingSide};
  const SvgPen panel = pen.moved_group(std::string("panel ") + kTitles[i], origin);
  panel.frame(
      {-0.5 * kRingSide, -0.5 * kRingSide - kRingTitle, 0.5 * kRingSide, 0.5 * kRingSide});
  panel.text({0.0, -0.5 * kRingSide - 0.5 * kRingTitle}, kTitles[i],
             {16.0, kColors[i], true, Anchor::kMiddle, false});
  RingPanelArtist(panel, *panels[i], part, figure.rim, focus).draw();
}

}  // namespace

Spot draw_ring(const SvgPen& pen, const Finding& finding) {
  const RingFigure& figure = finding.ring;
  for (const RingPart part : {RingPart::kBefore, RingPart::kYours, RingPart::kExpected})
    draw_titled(pen, figure, part, finding.element);
  const double width = 3.0 * kRingSide + 4.0 * kRingMargin;
  ListColumn column(pen.group("list"), {kRingMargin, kRingTitle + kRingSide + 6.0}, width);
  column.sentence("at " + finding.element + ": expected " + finding.expected);
  column.sentence("yours: " + finding.actual);
  column.gap();
  column.quiet("The faces around " + figure.picked +
               ", not as they lie in space. Red: not asked for. Blue, dashed: missing.");
  return {width, column.bottom() + kRingMargin};
}

}  // namespace meshgrade
