#pragma once

#include <string>

#include "grader/report/svg_pen.h"

namespace meshgrade {

/// Lines of text below each other, beneath a picture. What is too long is cut off.
class ListColumn {
 public:
  /// @param top    the upper left corner
  /// @param width  of the whole picture
  ListColumn(const SvgPen& pen, Spot top, double width)
      : pen_(pen), at_(top), width_(width - 2.0 * top.x) {}

  void heading(const std::string& text) {
    line(pen_.group("heading"), text, {14.0, ink::kText, true}, 0.0);
  }
  void sentence(const std::string& text) { line(pen_.group("sentence"), text, {13.5}, 0.0); }
  void quiet(const std::string& text) {
    line(pen_.group("quiet"), text, {13.0, ink::kQuiet}, 0.0);
  }

  /// With the number in a box, as the picture has it.
  void numbered(std::size_t number, const std::string& text) {
    const Spot middle = at_ + Spot{13.0, 0.5 * kLineHeight};
    const SvgPen group = pen_.group("item");
    group.attribute("data-number", std::to_string(number));
    group.box(box_around(middle, 24.0, 17.0), 4.0, ink::kWrong, {});
    group.text(middle, std::to_string(number), {13.0, ink::kPaper, true});
    line(group, text, {13.5}, 34.0);
  }

  void gap() { at_.y += 0.4 * kLineHeight; }

  double bottom() const { return at_.y; }

 private:
  static constexpr double kLineHeight = 20.0;

  /// @param group  keeps the whole text, for a page that breaks the line
  void line(const SvgPen& group, const std::string& text, Lettering lettering, double indent) {
    lettering.anchor = Anchor::kStart;
    lettering.code = indent > 0.0;
    const double letters = (width_ - indent) / text_width("m", lettering.size);
    group.attribute("data-text", text);
    group.text(at_ + Spot{indent, 0.5 * kLineHeight},
               shortened(text, static_cast<std::size_t>(letters)), lettering);
    at_.y += kLineHeight;
  }

  SvgPen pen_;
  Spot at_;
  double width_;
};

}  // namespace meshgrade
