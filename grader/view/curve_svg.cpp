#include "grader/view/curve_svg.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "grader/report/svg_pen.h"

namespace meshgrade {
namespace {

/// The same as in the page's style sheet.
struct CurveTheme {
  const char* ground;
  const char* ink;
  const char* polygon;
  const char* exact;
  const char* yours;
  const char* result;
  std::array<const char*, 3> levels;
};
constexpr CurveTheme kLightCurve{"#fbfcfd",
                                 "#2a3440",
                                 "#4a5560",
                                 "#c9d2dc",
                                 "#0a5ca8",
                                 "#c03a00",
                                 {"#00745a", "#8a5a00", "#7a3fa0"}};
constexpr CurveTheme kDarkCurve{"#171b20",
                                "#dfe5eb",
                                "#b4bec9",
                                "#3d4854",
                                "#7fbcf5",
                                "#ff8f5a",
                                {"#5fd3b0", "#f0bd5a", "#c79bf0"}};

class CurveArtist {
 public:
  CurveArtist(const SvgPen& pen, const CurveLook& look, const PictureRequest& request)
      : pen_(pen), look_(look), theme_(request.dark ? kDarkCurve : kLightCurve) {
    Point2 low{INFINITY, INFINITY};
    Point2 high{-INFINITY, -INFINITY};
    for (const Point2& p : look.points) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
    const auto [width, height] = std::pair(0.5 * request.size.width, 0.5 * request.size.height);
    const double reach =
        std::max({(high[0] - low[0]) / width, (high[1] - low[1]) / height, 1e-12});
    scale_ = 1.66 / reach;
    middle_ = {width - scale_ * 0.5 * (low[0] + high[0]),
               height + scale_ * 0.5 * (low[1] + high[1])};
  }

  void draw(std::size_t levels) const {
    path("exact", {look_.exact.begin(), look_.exact.end()}, {theme_.exact, 7.0});
    path("polygon", {look_.points.begin(), look_.points.end()}, {theme_.polygon, 1.5, "6 6"});
    path("curve", look_.curve, {theme_.yours, 3.0});
    for (std::size_t i = 0; i < std::min(levels, look_.levels.size()); ++i)
      draw_level(i);
    const SvgPen group = pen_.group("control");
    for (std::size_t i = 0; i < look_.points.size(); ++i) {
      const Spot at = place(look_.points[i]);
      group.circle(at, 5.5, theme_.ink, {theme_.ground, 1.5});
      group.text(at + label_way(i), "p" + std::to_string(i), {14.0, theme_.ink});
    }
  }

 private:
  Spot place(const Point2& p) const {
    const Spot at = middle_ + Spot{scale_ * p[0], -scale_ * p[1]};
    const auto near = [](double x) {
      return std::isfinite(x) ? std::clamp(x, -1e5, 1e5) : -1e5;
    };
    return {near(at.x), near(at.y)};
  }

  /// Away from the middle of the polygon.
  Spot label_way(std::size_t i) const {
    Spot sum;
    for (const Point2& p : look_.points)
      sum = sum + place(p);
    return 17.0 * unit(place(look_.points[i]) -
                       (1.0 / static_cast<double>(look_.points.size())) * sum);
  }

  void path(const char* name, const std::vector<std::optional<Point2>>& points,
            const Stroke& stroke) const {
    std::string steps;
    bool down = false;
    for (const std::optional<Point2>& p : points) {
      if (p) steps += down ? line_to(place(*p)) : move_to(place(*p));
      down = p.has_value();
    }
    if (!steps.empty()) pen_.group(name).path(steps, stroke);
  }

  void draw_level(std::size_t i) const {
    const std::vector<Point2>& points = look_.levels[i];
    const bool last = points.size() == 1 && i + 2 == look_.points.size();
    const char* color = last ? theme_.result : theme_.levels[i % theme_.levels.size()];
    const SvgPen group = pen_.group("level level-" + std::to_string(i + 1));
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      group.line(place(points[k]), place(points[k + 1]), {color, 2.2});
    for (const Point2& p : points)
      group.circle(place(p), last ? 8.0 : 4.5, color, {theme_.ground, 1.5});
  }

  SvgPen pen_;
  const CurveLook& look_;
  const CurveTheme& theme_;
  double scale_ = 1.0;
  Spot middle_;
};

}  // namespace

std::string curve_svg(const CurveLook& look, std::size_t levels, const PictureRequest& request,
                      const std::string& title) {
  return svg_document("meshgrade-picture", "picture", title, title, [&](pugi::xml_node svg) {
    const SvgPen pen(svg);
    const Spot size{static_cast<double>(request.size.width),
                    static_cast<double>(request.size.height)};
    pen.box({0.0, 0.0, size.x, size.y}, 0.0,
            request.dark ? kDarkCurve.ground : kLightCurve.ground, {});
    const Box whole{0.0, 0.0, size.x, size.y};
    CurveArtist(pen.clipped_group("drawing", whole), look, request).draw(levels);
    return size;
  });
}

}  // namespace meshgrade
