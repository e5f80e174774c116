#include "grader/report/svg_pen.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace meshgrade {
namespace {

constexpr const char* kSentenceFont = "DejaVu Sans, Helvetica, Arial, sans-serif";

/// Tenths are fine enough for the eye, and keep the file small.
std::string number(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.1f", std::isfinite(value) ? value : 0.0);
  std::string text = digits;
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text == "-0" ? "0" : text;
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

void set(pugi::xml_node node, const Stroke& stroke) {
  if (stroke.width <= 0.0) return;
  set(node, "stroke", stroke.color);
  set(node, "stroke-width", number(stroke.width));
  if (*stroke.dashes != '\0') set(node, "stroke-dasharray", stroke.dashes);
}

void append_text(pugi::xml_node svg, const char* element, const std::string& id,
                 const std::string& text) {
  pugi::xml_node node = svg.append_child(element);
  set(node, "id", id);
  node.text().set(text.c_str());
}

/// Of the root, once its size is known.
void set_size(pugi::xml_node svg, Spot size) {
  const std::string width = std::to_string(std::lround(size.x));
  const std::string height = std::to_string(std::lround(size.y));
  set(svg, "width", width);
  set(svg, "height", height);
  set(svg, "viewBox", "0 0 " + width + " " + height);
}

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

std::size_t count_characters(const std::string& text) {
  std::size_t count = 0;
  for (char c : text)
    count += begins_character(c) ? 1 : 0;
  return count;
}

}  // namespace

std::string mixed_color(const char* first, const char* second, double part) {
  std::string color = "#";
  for (std::size_t i = 1; i < 7; i += 2) {
    const auto channel = [&](const char* of) {
      return static_cast<double>(std::strtol(std::string(of + i, 2).c_str(), nullptr, 16));
    };
    char digits[3];
    const double value = (1.0 - part) * channel(first) + part * channel(second);
    std::snprintf(digits, sizeof digits, "%02x",
                  static_cast<unsigned>(std::lround(value)) & 0xFFU);
    color += digits;
  }
  return color;
}

double length(Spot p) {
  return std::hypot(p.x, p.y);
}

Spot unit(Spot p) {
  const double norm = length(p);
  return norm > 1e-9 ? (1.0 / norm) * p : Spot{1.0, 0.0};
}

Spot left_of(Spot direction) {
  return {direction.y, -direction.x};
}

double text_width(const std::string& text, double size) {
  return 0.61 * size * static_cast<double>(count_characters(text));
}

std::string shortened(const std::string& text, std::size_t most) {
  if (count_characters(text) <= most) return text;
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size(); ++end) {
    if (begins_character(text[end]) && count++ == most - 3) break;
  }
  return text.substr(0, end) + "...";
}

bool overlap(const Box& a, const Box& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

Box box_around(Spot centre, double width, double height) {
  return {centre.x - width / 2, centre.y - height / 2, centre.x + width / 2,
          centre.y + height / 2};
}

SvgPen SvgPen::group(const std::string& css_class) const {
  SvgPen pen(pugi::xml_node(node_).append_child("g"));
  pen.attribute("class", css_class);
  return pen;
}

SvgPen SvgPen::moved_group(const std::string& css_class, Spot origin) const {
  SvgPen pen = group(css_class);
  pen.attribute("transform", "translate(" + number(origin.x) + " " + number(origin.y) + ")");
  return pen;
}

SvgPen SvgPen::clipped_group(const std::string& css_class, const Box& box) const {
  // A clip path would need an id; an inner picture cuts off by itself.
  SvgPen pen(pugi::xml_node(node_).append_child("svg"));
  const std::string width = number(box.x1 - box.x0);
  const std::string height = number(box.y1 - box.y0);
  pen.attribute("class", css_class);
  pen.attribute("x", number(box.x0));
  pen.attribute("y", number(box.y0));
  pen.attribute("width", width);
  pen.attribute("height", height);
  pen.attribute("viewBox", number(box.x0) + " " + number(box.y0) + " " + width + " " + height);
  return pen;
}

void SvgPen::attribute(const char* name, const std::string& value) const {
  set(node_, name, value);
}

void SvgPen::frame(const Box& box) const {
  attribute("data-box", number(box.x0) + " " + number(box.y0) + " " + number(box.x1 - box.x0) +
                            " " + number(box.y1 - box.y0));
}

void SvgPen::tooltip(const std::string& text) const {
  pugi::xml_node(node_).prepend_child("title").text().set(text.c_str());
}

void SvgPen::path(const std::string& d, const Stroke& stroke, const char* fill) const {
  pugi::xml_node node = pugi::xml_node(node_).append_child("path");
  set(node, "d", d);
  set(node, "fill", fill);
  set(node, stroke);
}

void SvgPen::line(Spot from, Spot to, const Stroke& stroke) const {
  path(move_to(from) + line_to(to), stroke);
}

void SvgPen::polygon(const std::vector<Spot>& corners, const char* fill,
                     const Stroke& stroke) const {
  std::string d;
  for (Spot corner : corners)
    d += d.empty() ? move_to(corner) : line_to(corner);
  path(d + "Z", stroke, fill);
}

void SvgPen::arrowhead(Spot tip, Spot direction, double size, const char* color) const {
  const Spot back = tip - size * unit(direction);
  const Spot side = 0.42 * size * left_of(unit(direction));
  polygon({tip, back + side, back - side}, color, {});
}

void SvgPen::circle(Spot centre, double radius, const char* fill, const Stroke& stroke) const {
  pugi::xml_node node = pugi::xml_node(node_).append_child("circle");
  set(node, "cx", number(centre.x));
  set(node, "cy", number(centre.y));
  set(node, "r", number(radius));
  set(node, "fill", fill);
  set(node, stroke);
}

void SvgPen::box(const Box& box, double rounding, const char* fill,
                 const Stroke& stroke) const {
  pugi::xml_node node = pugi::xml_node(node_).append_child("rect");
  set(node, "x", number(box.x0));
  set(node, "y", number(box.y0));
  set(node, "width", number(box.x1 - box.x0));
  set(node, "height", number(box.y1 - box.y0));
  set(node, "rx", number(rounding));
  set(node, "fill", fill);
  set(node, stroke);
}

void SvgPen::text(Spot middle, const std::string& text, const Lettering& lettering) const {
  constexpr const char* kAnchors[] = {"start", "middle", "end"};
  pugi::xml_node node = pugi::xml_node(node_).append_child("text");
  set(node, "x", number(middle.x));
  set(node, "y", number(middle.y + 0.35 * lettering.size));  // the line that letters stand on
  set(node, "font-size", number(lettering.size));
  if (!lettering.code) set(node, "font-family", kSentenceFont);
  set(node, "fill", lettering.color);
  if (lettering.bold) set(node, "font-weight", "bold");
  if (lettering.anchor != Anchor::kStart) {
    set(node, "text-anchor", kAnchors[static_cast<std::size_t>(lettering.anchor)]);
  }
  node.text().set(text.c_str());
}

std::string svg_document(const std::string& css_class, const std::string& id,
                         const std::string& title, const std::string& description,
                         const std::function<Spot(pugi::xml_node)>& draw) {
  pugi::xml_document document;
  pugi::xml_node svg = document.append_child("svg");
  set(svg, "xmlns", "http://www.w3.org/2000/svg");
  set(svg, "class", css_class);
  set(svg, "role", "img");
  set(svg, "font-family", "DejaVu Sans Mono, Menlo, Consolas, monospace");
  set(svg, "aria-labelledby", id + "-title " + id + "-desc");
  append_text(svg, "title", id + "-title", title);
  append_text(svg, "desc", id + "-desc", description);
  set_size(svg, draw(svg));
  std::ostringstream text;
  document.save(text, "", pugi::format_raw | pugi::format_no_declaration);
  return text.str() + "\n";
}

std::string move_to(Spot p) {
  return "M" + number(p.x) + " " + number(p.y);
}

std::string line_to(Spot p) {
  return "L" + number(p.x) + " " + number(p.y);
}

std::string curve_to(Spot control, Spot end) {
  return "Q" + number(control.x) + " " + number(control.y) + " " + number(end.x) + " " +
         number(end.y);
}

}  // namespace meshgrade
