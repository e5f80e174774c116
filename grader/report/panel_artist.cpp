#include "grader/report/panel_artist.h"

#include <algorithm>

#include "grader/report/figure_text.h"

namespace meshgrade {
namespace {

using Kind = ElementKind;

constexpr double kNameSize = 13.0;
constexpr double kSmallSize = 13.0;
constexpr double kTagSize = 13.0;
constexpr double kTagHeight = 17.0;
constexpr double kHeadSize = 14.0;  // of an arrow's head, which no label hides
constexpr double kClose = 60.0;     // from a tip to where the next half-edge begins

/// A wrong pointer as an arrow: from its element to where it leads.
struct Connector {
  Spot start;
  Spot control;
  Spot end;
  bool leads_out = false;  ///< of the picture, or to nothing: it ends in its tag
  bool is_hook = false;    ///< the short way to a next half-edge, which shows its own direction

  Spot at(double t) const {
    const double s = 1.0 - t;
    return s * s * start + 2.0 * s * t * control + t * t * end;
  }
};

class PanelArtist {
 public:
  PanelArtist(const SvgPen& pen, const PanelTask& task)
      : pen_(pen),
        task_(task),
        panel_(task.panel()),
        layout_(panel_),
        labels_(layout_.frame()),
        alarm_(task.part == PanelPart::kExpected ? ink::kRight : ink::kWrong) {
    if (task.part == PanelPart::kBefore) return;
    const std::size_t drawn = std::min(task.figure.faults.size(), kMostDrawnFaults);
    for (std::size_t i = 0; i < drawn; ++i) {
      if (task.figure.faults[i].place != kNotPictured) faults_.push_back(i);
    }
  }

  void draw() {
    reserve_labels();
    draw_faces();
    draw_edges();
    for (std::size_t i = 0; i < halfedges().size(); ++i)
      draw_halfedge(i);
    std::vector<Connector> connectors;
    for (std::size_t i : faults_) {
      connectors.push_back(connector(task_.figure.faults[i]));
      labels_.take(box_around(connectors.back().end, kHeadSize, kHeadSize));
      draw_connector(connectors.back(), i);
    }
    draw_names();
    for (std::size_t i = 0; i < faults_.size(); ++i)
      draw_tag(connectors[i], faults_[i]);
  }

 private:
  const std::vector<FigureElement>& halfedges() const { return panel_.of(Kind::kHalfedge); }

  const FigureElement& element(Kind kind, std::size_t i) const { return panel_.of(kind)[i]; }

  bool is_missing(Kind kind, std::size_t i) const {
    return task_.part == PanelPart::kYours && element(kind, i).pointers.empty();
  }
  bool is_new(Kind kind, std::size_t i) const {
    return task_.part == PanelPart::kExpected && element(kind, i).name.empty();
  }

  bool is_faulty(Kind kind, std::size_t i) const {
    if (task_.part != PanelPart::kYours) return false;
    const FigureElement& e = element(kind, i);
    if (!e.name.empty() && e.name == task_.focus) return true;
    return std::any_of(task_.figure.faults.begin(), task_.figure.faults.end(),
                       [&](const FigureFault& f) { return f.kind == kind && f.place == i; });
  }

  bool is_faulty_pointer(Kind kind, std::size_t i, std::size_t pointer) const {
    return task_.part == PanelPart::kYours &&
           std::any_of(task_.figure.faults.begin(), task_.figure.faults.end(),
                       [&](const FigureFault& f) {
                         return f.kind == kind && f.place == i && f.pointer == pointer;
                       });
  }

  std::string css_class(const char* kind_name, Kind kind, std::size_t i) const {
    std::string text = kind_name;
    if (is_faulty(kind, i)) text += " wrong";
    if (is_missing(kind, i)) text += " missing";
    if (is_new(kind, i)) text += " new";
    return text;
  }

  /// A pointer that is wrong must lead here.
  bool is_wanted(Kind kind, std::size_t i) const {
    return task_.part == PanelPart::kExpected &&
           std::any_of(faults_.begin(), faults_.end(), [&](std::size_t f) {
             const FigureFault& fault = task_.figure.faults[f];
             return target_kind(fault.kind, fault.pointer) == kind &&
                    pointer_of(fault).place == i;
           });
  }

  const FigurePointer& pointer_of(const FigureFault& fault) const {
    return element(fault.kind, fault.place).pointers[fault.pointer];
  }

  bool stands_out(Kind kind, std::size_t i) const {
    return is_faulty(kind, i) || is_wanted(kind, i);
  }

  const char* color(Kind kind, std::size_t i, const char* usual) const {
    if (is_faulty(kind, i) || is_missing(kind, i)) return ink::kWrong;
    return is_new(kind, i) || is_wanted(kind, i) ? ink::kRight : usual;
  }

  // ---- names -----------------------------------------------------------------------------

  std::string label(Kind kind, std::size_t i) const {
    const FigureElement& e = element(kind, i);
    const bool exists = !e.name.empty();
    const bool deleted = exists && is_missing(kind, i);
    const std::string what = deleted                           ? "no " + e.name
                             : exists                          ? e.name
                             : task_.part == PanelPart::kYours ? "no"
                                                               : "new";
    switch (kind) {
      case Kind::kHalfedge:
        return exists ? what : what + " " + e.corners;
      case Kind::kVertex:
        return exists ? e.corners + " " + what : what + " " + e.corners;
      case Kind::kEdge:
        return exists ? what : what + " edge";
      default:
        return exists ? what + (e.outside ? " (outside)" : "") : what + " face";
    }
  }

  Spot label_spot(Kind kind, std::size_t i) const {
    switch (kind) {
      case Kind::kHalfedge:
        return layout_.arrow(i).label;
      case Kind::kVertex:
        return layout_.vertex(i);
      case Kind::kEdge:
        return layout_.edge_label(i);
      default:
        return layout_.face_label(i);
    }
  }

  Box label_box(Kind kind, std::size_t i) const {
    const bool large = kind == Kind::kHalfedge || kind == Kind::kVertex;
    const double size = large ? kNameSize : kSmallSize;
    const double margin = kind == Kind::kVertex ? 10.0 : 3.0;
    return box_around(label_spot(kind, i), text_width(label(kind, i), size) + margin,
                      kind == Kind::kVertex ? 19.0 : size + 1.5);
  }

  void reserve_labels() {
    for (std::size_t i = 0; i < halfedges().size(); ++i)
      labels_.take(box_around(layout_.arrow(i).at(0.96), kHeadSize, kHeadSize));
    for (Kind kind : {Kind::kVertex, Kind::kHalfedge, Kind::kEdge, Kind::kFace}) {
      for (std::size_t i = 0; i < panel_.of(kind).size(); ++i)
        labels_.take(label_box(kind, i));
    }
  }

  void draw_names() {
    for (std::size_t i = 0; i < panel_.of(Kind::kEdge).size(); ++i)
      draw_name("edge-name", Kind::kEdge, i, kSmallSize, ink::kQuiet);
    for (std::size_t i = 0; i < panel_.of(Kind::kFace).size(); ++i)
      draw_name("face-name", Kind::kFace, i, kSmallSize, ink::kQuiet);
    for (std::size_t i = 0; i < halfedges().size(); ++i)
      draw_name("halfedge-name", Kind::kHalfedge, i, kNameSize, ink::kText);
    for (std::size_t i = 0; i < panel_.of(Kind::kVertex).size(); ++i)
      draw_vertex(i);
  }

  void draw_name(const char* kind_name, Kind kind, std::size_t i, double size,
                 const char* usual) {
    const SvgPen group = pen_.group(css_class(kind_name, kind, i));
    group.tooltip(element_text(panel_, kind, i));
    const bool on_face = kind == Kind::kFace && !element(kind, i).outside;
    group.box(label_box(kind, i), 3.0, on_face ? ink::kFace : ink::kPaper, {});
    group.text(label_spot(kind, i), label(kind, i),
               {size, color(kind, i, usual), stands_out(kind, i)});
  }

  void draw_vertex(std::size_t i) {
    const SvgPen group = pen_.group(css_class("vertex", Kind::kVertex, i));
    group.tooltip(element_text(panel_, Kind::kVertex, i));
    const char* ground = color(Kind::kVertex, i, ink::kText);
    const bool hollow = is_missing(Kind::kVertex, i) || is_new(Kind::kVertex, i);
    group.box(label_box(Kind::kVertex, i), 9.5, hollow ? ink::kPaper : ground,
              {ground, 1.5, hollow ? "4 3" : ""});
    group.text(label_spot(Kind::kVertex, i), label(Kind::kVertex, i),
               {kNameSize, hollow ? ground : ink::kPaper, true});
  }

  // ---- faces, edges, half-edges ------------------------------------------------------------

  void draw_faces() {
    for (std::size_t i = 0; i < panel_.of(Kind::kFace).size(); ++i) {
      if (layout_.face_corners(i).empty()) continue;
      const bool missing = is_missing(Kind::kFace, i);
      pen_.group(css_class("face", Kind::kFace, i))
          .polygon(layout_.face_corners(i), missing ? ink::kPaper : ink::kFace, {});
    }
  }

  void draw_edges() {
    for (std::size_t i = 0; i < panel_.of(Kind::kEdge).size(); ++i) {
      const bool missing = is_missing(Kind::kEdge, i);
      pen_.group(css_class("edge", Kind::kEdge, i))
          .line(layout_.edge_start(i), layout_.edge_end(i),
                {ink::kEdge, 1.5, missing ? "3 4" : ""});
    }
  }

  void draw_halfedge(std::size_t i) {
    const SvgPen group = pen_.group(css_class("halfedge", Kind::kHalfedge, i));
    const FigureElement& h = halfedges()[i];
    group.attribute("data-corners", h.corners + (h.outside ? " outside" : ""));
    group.tooltip(element_text(panel_, Kind::kHalfedge, i));
    const HalfedgeArrow& arrow = layout_.arrow(i);
    const char* tint = color(Kind::kHalfedge, i, ink::kArrow);
    const double width = stands_out(Kind::kHalfedge, i) ? 3.6 : 1.8;
    group.line(arrow.tail, arrow.tip - 5.0 * arrow.direction(),
               {tint, width, is_missing(Kind::kHalfedge, i) ? "2 4" : ""});
    group.arrowhead(arrow.tip, arrow.direction(), width > 2.0 ? 14.0 : 10.0, tint);
    draw_next(group, i);
  }

  /// The way from the tip to the next half-edge, where that is close and right.
  void draw_next(const SvgPen& group, std::size_t i) {
    if (halfedges()[i].pointers.empty() || is_faulty_pointer(Kind::kHalfedge, i, 0)) return;
    const std::size_t next = halfedges()[i].pointers[0].place;
    if (next == kNotPictured) return;
    const HalfedgeArrow& arrow = layout_.arrow(i);
    const Spot end = layout_.arrow(next).tail;
    if (length(end - arrow.tip) > kClose) return;
    group.path(move_to(arrow.tip) + curve_to(arrow.turn, end), {ink::kArrow, 1.2});
  }

  // ---- wrong pointers ----------------------------------------------------------------------

  Spot departure(const FigureFault& fault) const {
    if (fault.kind != Kind::kHalfedge) return label_spot(fault.kind, fault.place);
    const HalfedgeArrow& arrow = layout_.arrow(fault.place);
    // next leaves at the tip, vertex at the tail, twin, edge and face in between.
    constexpr double kPart[] = {1.0, 0.5, 0.0, 0.55, 0.6};
    return arrow.at(kPart[fault.pointer]);
  }

  Spot arrival(const FigureFault& fault, std::size_t target) const {
    const Kind kind = target_kind(fault.kind, fault.pointer);
    if (kind != Kind::kHalfedge) return label_spot(kind, target);
    const HalfedgeArrow& arrow = layout_.arrow(target);
    if (fault.kind == Kind::kHalfedge && fault.pointer == 0) return arrow.tail;
    return arrow.at(fault.kind == Kind::kVertex ? 0.15 : 0.5);
  }

  /// The way that a half-edge's own direction suggests; for others, into the picture.
  Spot leaning(const FigureFault& fault, Spot from) const {
    if (fault.kind == Kind::kHalfedge && fault.pointer == 0) {
      return layout_.arrow(fault.place).direction();
    }
    return -1.0 * unit(from);
  }

  Connector connector(const FigureFault& fault) const {
    const FigurePointer& pointer = pointer_of(fault);
    const Spot start = departure(fault);
    const Spot lean = leaning(fault, start);
    if (pointer.place == kNotPictured) {
      return {start, start + 22.0 * lean, start + 44.0 * lean, true, false};
    }
    const Spot end = arrival(fault, pointer.place);
    const bool next = fault.kind == Kind::kHalfedge && fault.pointer == 0;
    if (next && length(end - start) < kClose && task_.part == PanelPart::kExpected) {
      return {start, layout_.arrow(fault.place).turn, end, false, true};
    }
    if (length(end - start) < 8.0) {  // it leads back to where it comes from
      const Spot side = left_of(lean);
      return {start, start + 60.0 * lean, start + 18.0 * side, false, false};
    }
    Spot side = left_of(unit(end - start));
    if (side.x * lean.x + side.y * lean.y < 0.0) side = -1.0 * side;
    const double bend = std::clamp(0.3 * length(end - start), 18.0, 60.0);
    const Spot control = 0.5 * (start + end) + bend * side;
    const Kind kind = target_kind(fault.kind, fault.pointer);
    if (kind == Kind::kHalfedge) return {start, control, end, false, false};
    return cut_at({start, control, end, false, false}, label_box(kind, pointer.place));
  }

  /// The part of a connector in front of the label that it leads to.
  static Connector cut_at(const Connector& c, const Box& label) {
    double t = 1.0;
    while (t > 0.3 && overlap(label, box_around(c.at(t), 2.0, 2.0)))
      t -= 0.02;
    return {c.start, c.start + t * (c.control - c.start), c.at(t), false, false};
  }

  std::string tag_text(std::size_t i) const {
    const FigureFault& fault = task_.figure.faults[i];
    const FigurePointer& pointer = pointer_of(fault);
    return std::to_string(i + 1) + " " + pointer_name(fault.kind, fault.pointer) +
           (pointer.place == kNotPictured ? ": " + shortened(pointer.text, 10) : "");
  }

  void draw_connector(const Connector& c, std::size_t i) {
    if (c.leads_out) return;  // drawn with its tag
    const SvgPen group = pen_.group("pointer " + pointer_class());
    group.tooltip(task_.figure.faults[i].text);
    group.path(move_to(c.start) + curve_to(c.control, c.end),
               {alarm_, 2.4, task_.part == PanelPart::kYours ? "6 4" : ""});
    if (!c.is_hook) group.arrowhead(c.end, c.end - c.control, 11.0, alarm_);
    group.circle(c.start, 3.2, alarm_, {});
  }

  std::string pointer_class() const {
    return task_.part == PanelPart::kYours ? "wrong" : "right";
  }

  /// On the connector; beside it if that is too short to be seen under the tag; around its
  /// start if it leads out of the picture.
  static std::vector<Spot> tag_spots(const Connector& c, double width) {
    std::vector<Spot> spots;
    if (c.leads_out) {
      for (double far : {1.0, 1.4, 1.8}) {
        const Spot way = far * (c.end - c.start);
        for (Spot turned : {way, way + left_of(way), way - left_of(way), left_of(way),
                            -1.0 * left_of(way), -1.0 * way})
          spots.push_back(c.start + turned);
      }
      return spots;
    }
    const Spot middle = c.at(0.5);
    if (length(c.end - c.start) > width + 20.0) {
      for (double t : {0.5, 0.38, 0.62, 0.28, 0.72})
        spots.push_back(c.at(t));
    }
    const double out = middle.x < 0.0 ? -1.0 : 1.0;
    for (double far : {0.5 * width + 16.0, 0.5 * width + 34.0}) {
      for (Spot way : {Spot{out, 0.35}, Spot{out, -0.35}, Spot{-out, 0.35}, Spot{0.3, 1.0},
                       Spot{0.3, -1.0}})
        spots.push_back(middle + far * way);
    }
    return spots;
  }

  void draw_tag(const Connector& c, std::size_t i) {
    const std::string text = tag_text(i);
    const double width = text_width(text, kTagSize) + 10.0;
    const Spot spot = labels_.place(tag_spots(c, width), width, kTagHeight);
    const SvgPen group = pen_.group("tag " + pointer_class());
    group.tooltip(task_.figure.faults[i].text);
    if (c.leads_out) {
      group.line(c.start, spot, {alarm_, 2.4, task_.part == PanelPart::kYours ? "6 4" : ""});
      group.circle(c.start, 3.2, alarm_, {});
    } else {
      group.line(c.at(0.5), spot, {alarm_, 1.2});
    }
    group.box(box_around(spot, width, kTagHeight), 4.0, alarm_, {ink::kPaper, 1.0});
    group.text(spot, text, {kTagSize, ink::kPaper, true});
  }

  SvgPen pen_;
  const PanelTask& task_;
  const FigurePanel& panel_;
  DiamondLayout layout_;
  LabelBoxes labels_;
  const char* alarm_;
  std::vector<std::size_t> faults_;  // that are drawn
};

}  // namespace

void draw_panel(const SvgPen& pen, const PanelTask& task) {
  PanelArtist(pen, task).draw();
}

}  // namespace meshgrade
