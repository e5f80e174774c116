#pragma once

// Shapes of an SVG picture. It carries no style sheet and no ids but those of its description,
// so that many pictures can stand in one HTML page.

#include <functional>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace meshgrade {

/// A point or a direction of the picture: x to the right, y down.
struct Spot {
  double x = 0.0;
  double y = 0.0;

  friend Spot operator+(Spot p, Spot q) { return {p.x + q.x, p.y + q.y}; }
  friend Spot operator-(Spot p, Spot q) { return {p.x - q.x, p.y - q.y}; }
  friend Spot operator*(double s, Spot p) { return {s * p.x, s * p.y}; }
};
double length(Spot p);
/// In the same direction with length 1; (1, 0) if it has no direction.
Spot unit(Spot p);
/// Turned left by a right angle, as one sees it.
Spot left_of(Spot direction);

/// Readable on the picture's white ground, also for the colour-blind: wrong is vermilion, right
/// is blue, and neither is told by its colour alone.
namespace ink {
constexpr const char* kPaper = "#ffffff";
constexpr const char* kText = "#1c2733";
constexpr const char* kQuiet = "#536371";
constexpr const char* kArrow = "#5b7083";
constexpr const char* kEdge = "#a9b5c0";
constexpr const char* kFace = "#f0f4f7";
constexpr const char* kWrong = "#b83a00";
constexpr const char* kRight = "#00559c";
}  // namespace ink

/// "#rrggbb" between two such colours: `part` 0 gives the first, 1 the second.
std::string mixed_color(const char* first, const char* second, double part);

struct Stroke {
  const char* color = ink::kText;
  double width = 0.0;       ///< 0: no line
  const char* dashes = "";  ///< "6 4"
};

enum class Anchor { kStart, kMiddle, kEnd };

struct Lettering {
  double size = 12.0;
  const char* color = ink::kText;
  bool bold = false;
  Anchor anchor = Anchor::kMiddle;
  bool code = true;  ///< in a type whose letters are all equally wide
};

/// How wide a text of the code type is, or a bit less than a sentence in the other.
double text_width(const std::string& text, double size);

/// The text, cut off with "..." to so many characters.
std::string shortened(const std::string& text, std::size_t most);

struct Box {
  double x0 = 0.0;
  double y0 = 0.0;
  double x1 = 0.0;
  double y1 = 0.0;
};
bool overlap(const Box& a, const Box& b);
Box box_around(Spot centre, double width, double height);

/// Appends shapes to a group of an SVG document.
class SvgPen {
 public:
  explicit SvgPen(pugi::xml_node node) : node_(node) {}

  SvgPen group(const std::string& css_class) const;
  /// A group with its origin here.
  SvgPen moved_group(const std::string& css_class, Spot origin) const;
  /// A group that shows nothing outside of its box; its coordinates are those around it.
  SvgPen clipped_group(const std::string& css_class, const Box& box) const;

  void attribute(const char* name, const std::string& value) const;
  /// What the group takes up, in its own coordinates, for a page that shows it alone:
  /// data-box="x y width height".
  void frame(const Box& box) const;
  /// What a browser shows when the pointer rests on the group.
  void tooltip(const std::string& text) const;
  void path(const std::string& d, const Stroke& stroke, const char* fill = "none") const;
  void line(Spot from, Spot to, const Stroke& stroke) const;
  void polygon(const std::vector<Spot>& corners, const char* fill, const Stroke& stroke) const;
  void arrowhead(Spot tip, Spot direction, double size, const char* color) const;
  void circle(Spot centre, double radius, const char* fill, const Stroke& stroke) const;
  void box(const Box& box, double rounding, const char* fill, const Stroke& stroke) const;
  /// `middle` is the middle of the letters' height.
  void text(Spot middle, const std::string& text, const Lettering& lettering) const;

 private:
  pugi::xml_node node_;
};

/// A whole SVG document that can also stand inside an HTML page.
///
/// @param id     letters, digits, "_" and "-": no other picture of the page may have the same
/// @param title, description  what the picture is of, for those who do not see it
/// @param draw   draws the picture and returns its width and height
std::string svg_document(const std::string& css_class, const std::string& id,
                         const std::string& title, const std::string& description,
                         const std::function<Spot(pugi::xml_node)>& draw);

/// Steps of a path.
std::string move_to(Spot p);
std::string line_to(Spot p);
std::string curve_to(Spot control, Spot end);

}  // namespace meshgrade
