#include "grader/report/surface_svg.h"

#include <algorithm>
#include <cmath>

#include "grader/base/text.h"
#include "grader/judge/normals.h"
#include "grader/report/figure_text.h"
#include "grader/report/label_boxes.h"
#include "grader/report/list_column.h"
#include "grader/report/projection.h"

namespace meshgrade {
namespace {

using meshedit::Vector3D;

constexpr double kSide = 440.0;
constexpr double kMargin = 14.0;
constexpr double kTitleHeight = 28.0;
constexpr double kTilt = 0.6;  // off the normal, so that an error along it can be seen
constexpr double kVertexTagSize = 13.5;
constexpr std::size_t kMostTags = 6;
constexpr std::size_t kMostHollow = 40;
constexpr std::size_t kMostListedVertices = 10;

/// The view from one side, without perspective.
class View : public Projection {
 public:
  /// @param towards  the direction from the surface to the eye
  View(const Vector3D& towards, const std::vector<Point3>& fit)
      : Projection(towards, std::fabs(towards.y) < 0.9 ? Vector3D(0.0, 1.0, 0.0)
                                                       : Vector3D(0.0, 0.0, 1.0)) {
    Box box{INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (const Point3& p : fit) {
      const Spot s = on_screen(p);
      box = {std::min(box.x0, s.x), std::min(box.y0, s.y), std::max(box.x1, s.x),
             std::max(box.y1, s.y)};
    }
    const double size = std::max(box.x1 - box.x0, box.y1 - box.y0);
    scale_ = size > 0.0 && std::isfinite(size) ? 0.8 * kSide / size : 1.0;
    middle_ = {0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
    height_ = std::min(kSide, scale_ * (box.y1 - box.y0) + 0.25 * kSide);
  }

  /// Around the middle of the panel; what is far outside is brought near its border.
  Spot project(const Point3& p) const {
    const Spot s = scale_ * (on_screen(p) - middle_);
    const auto near = [](double x) {
      return std::isfinite(x) ? std::clamp(x, -2.0 * kSide, 2.0 * kSide) : 0.0;
    };
    return {near(s.x), near(s.y)};
  }
  /// What a panel takes up, around its middle.
  Box frame() const { return box_around({}, kSide, height_); }

 private:
  double scale_ = 1.0;
  double height_ = kSide;
  Spot middle_;
};

std::vector<Point3> normals_of(const TriangleSurface& surface) {
  PolygonMesh mesh{surface.positions, {}};
  for (const auto& t : surface.triangles)
    mesh.polygons.push_back({t[0], t[1], t[2]});
  return vertex_normals(mesh, NormalWeight::kArea);
}

View choose_view(const SurfaceFigure& figure) {
  const std::size_t front = figure.marks.empty() ? 0 : figure.marks[0].expected;
  Vector3D normal = vector_of(normals_of(figure.expected)[front]);
  if (!is_finite(normal)) normal = {0.0, 0.0, 1.0};
  const Vector3D other =
      std::fabs(normal.y) < 0.9 ? Vector3D(0.0, 1.0, 0.0) : Vector3D(0.0, 0.0, 1.0);
  const Vector3D aside = cross(normal, other).unit();
  const Vector3D above = cross(aside, normal);
  const Vector3D towards =
      std::cos(kTilt) * normal + std::sin(kTilt) * (0.6 * aside + 0.8 * above);
  return {towards.unit(), figure.expected.positions};
}

/// One of the two surfaces.
class SurfacePanel {
 public:
  SurfacePanel(const SvgPen& pen, const SurfaceFigure& figure, const View& view, bool yours)
      : pen_(pen),
        figure_(figure),
        view_(view),
        yours_(yours),
        surface_(yours ? figure.yours : figure.expected),
        normals_(normals_of(surface_)),
        labels_(view.frame()) {}

  void draw_triangles() const {
    const SvgPen pen = pen_.clipped_group("surface", view_.frame());
    std::vector<double> depth;
    for (const auto& t : surface_.triangles) {
      depth.push_back(view_.depth(surface_.positions[t[0]]) +
                      view_.depth(surface_.positions[t[1]]) +
                      view_.depth(surface_.positions[t[2]]));
    }
    for (std::size_t i : far_to_near(depth))
      draw_triangle(pen, surface_.triangles[i]);
  }

  void draw_marks() {
    const char* color = yours_ ? ink::kWrong : ink::kRight;
    const SvgPen pen = pen_.group(yours_ ? "marks wrong" : "marks right");
    const SvgPen dots = pen.clipped_group("dots", view_.frame());
    // The right surface names only the worst; where many are wrong, those behind are too much.
    const std::size_t shown =
        yours_ ? figure_.marks.size() : std::min(figure_.marks.size(), kMostTags);
    for (std::size_t i = 0; i < shown; ++i) {
      const SurfaceMark& mark = figure_.marks[i];
      const bool hidden = is_hidden(vertex_of(mark));
      if (hidden && i >= kMostTags && shown > kMostHollow) continue;
      dots.circle(spot(vertex_of(mark)), hidden ? 2.2 : 3.0, hidden ? "none" : color,
                  {color, hidden ? 1.0 : 0.0});
    }
    for (std::size_t i = 0; i < std::min(figure_.marks.size(), kMostTags); ++i)
      draw_tag(pen, i, color);
  }

  /// From where the worst vertices are to where they must be.
  void draw_ways() const {
    const SvgPen pen = pen_.clipped_group("ways", view_.frame());
    for (std::size_t i = 0; i < std::min(figure_.marks.size(), kMostTags); ++i) {
      const Spot from = spot(figure_.marks[i].vertex);
      const Spot to = view_.project(figure_.expected.positions[figure_.marks[i].expected]);
      if (length(to - from) < 8.0) continue;
      pen.line(from, to, {ink::kRight, 1.8, "4 3"});
      pen.arrowhead(to, to - from, 9.0, ink::kRight);
    }
  }

 private:
  std::uint32_t vertex_of(const SurfaceMark& mark) const {
    return yours_ ? mark.vertex : mark.expected;
  }

  Spot spot(std::uint32_t vertex) const { return view_.project(surface_.positions[vertex]); }

  bool is_hidden(std::uint32_t vertex) const {
    return dot(vector_of(normals_[vertex]), view_.towards()) < 0.0;
  }

  void draw_triangle(const SvgPen& pen, const std::array<std::uint32_t, 3>& t) const {
    constexpr const char* kShades[] = {"#c3cdd6", "#d3dbe2", "#e1e7ec", "#edf1f4", "#f8fafb"};
    const double facing = view_.facing(surface_.positions[t[0]], surface_.positions[t[1]],
                                       surface_.positions[t[2]]);
    const auto shade = facing <= 0.0 ? 0 : static_cast<std::size_t>(1.0 + 3.0 * facing);
    pen.polygon({spot(t[0]), spot(t[1]), spot(t[2])}, kShades[std::min<std::size_t>(shade, 4)],
                {"#8796a4", 0.7});
  }

  void draw_tag(const SvgPen& pen, std::size_t i, const char* color) {
    const SurfaceMark& mark = figure_.marks[i];
    const std::string text = std::to_string(i + 1) + " " + mark.name;
    const double width = text_width(text, kVertexTagSize) + 10.0;
    const Spot at = spot(vertex_of(mark));
    std::vector<Spot> wanted;
    for (Spot way : {Spot{0.0, -24.0}, Spot{0.0, 24.0}, Spot{46.0, -10.0}, Spot{-46.0, -10.0}})
      wanted.push_back(at + way);
    const Spot place = labels_.place(wanted, width, 17.0);
    const SvgPen group = pen.group("tag");
    group.tooltip(mark.name + ": " + mark.text);
    group.line(at, place, {color, 1.2});
    if (yours_) {
      group.circle(at, 7.0, "none", {color, 2.0, is_hidden(mark.vertex) ? "3 2" : ""});
    }
    group.box(box_around(place, width, 17.0), 4.0, color, {ink::kPaper, 1.0});
    group.text(place, text, {kVertexTagSize, ink::kPaper, true});
  }

  SvgPen pen_;
  const SurfaceFigure& figure_;
  const View& view_;
  bool yours_;
  const TriangleSurface& surface_;
  std::vector<Point3> normals_;
  LabelBoxes labels_;
};

SvgPen panel_pen(const SvgPen& pen, const Box& frame, int number, const char* css_class,
                 const std::string& title, const char* color) {
  const Spot origin{kMargin + (number + 0.5) * kSide + number * kMargin,
                    kTitleHeight - frame.y0};
  const SvgPen panel = pen.moved_group(css_class, origin);
  panel.frame({frame.x0, frame.y0 - kTitleHeight, frame.x1, frame.y1});
  panel.text({0.0, frame.y0 - 0.5 * kTitleHeight}, title,
             {16.0, color, true, Anchor::kMiddle, false});
  return panel;
}

void list_marks(ListColumn& column, const SurfaceFigure& figure) {
  if (!figure.marks.empty()) column.heading("The worst first:");
  for (std::size_t i = 0; i < std::min(figure.marks.size(), kMostListedVertices); ++i) {
    column.numbered(i + 1, figure.marks[i].name + ": " + figure.marks[i].text);
  }
  if (figure.marks.size() > kMostListedVertices) {
    column.sentence("and " + std::to_string(figure.marks.size() - kMostListedVertices) +
                    " more");
  }
  column.gap();
  column.quiet(figure.marks.size() > kMostHollow
                   ? "Every wrong vertex on this side of the mesh has a dot."
                   : "Every wrong vertex has a dot; on the far side of the mesh it is hollow.");
  if (figure.left_out > 0) {
    column.quiet("Only what lies around the worst vertex is shown: " +
                 plural(figure.left_out, "triangle") + " left out.");
  }
}

}  // namespace

Spot draw_surface(const SvgPen& pen, const SurfaceFigure& figure) {
  const View view = choose_view(figure);
  const Box frame = view.frame();
  const std::size_t count = figure.marks.size();
  const std::string title = count == 0 ? "yours"
                                       : "yours: " + std::to_string(count) +
                                             (count == 1 ? " vertex " : " vertices ") +
                                             fault_text(figure);
  SurfacePanel yours(panel_pen(pen, frame, 0, "panel yours", title, ink::kWrong), figure, view,
                     true);
  yours.draw_triangles();
  if (figure.is_misplaced) yours.draw_ways();
  yours.draw_marks();
  SurfacePanel right(panel_pen(pen, frame, 1, "panel expected", "expected", ink::kRight),
                     figure, view, false);
  right.draw_triangles();
  right.draw_marks();
  const double width = 2.0 * kSide + 3.0 * kMargin;
  ListColumn column(pen.group("list"), {kMargin, kTitleHeight + 2.0 * frame.y1 + 6.0}, width);
  list_marks(column, figure);
  return {width, column.bottom() + kMargin};
}

}  // namespace meshgrade
