#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace meshgrade {

/// The text with every control character but tab and newline, and every byte sequence that is
/// not valid UTF-8, replaced by a visible "?". What comes from a student goes through this
/// before it reaches a terminal or a report.
std::string printable(std::string_view text);

/// The same as text of a page of HTML, also in an attribute: what is quoted of a student's code
/// or output rules no page.
std::string html_text(std::string_view text);

/// What a name of C++ is made of.
bool is_word_character(char c);

std::vector<std::string> split_lines(std::string_view text);
std::string join(const std::vector<std::string>& parts, std::string_view between);

/// A number as a person would write it: up to `digits` significant digits, no trailing zeros.
std::string number_text(double value, int digits = 6);

/// "(0.5, 1, 0)"
template <class Point>
std::string point_text(const Point& point) {
  double largest = 0.0;
  for (double x : point)
    largest = std::max(largest, std::abs(x));
  std::string text = "(";
  for (double x : point) {
    const bool noise = std::abs(x) < 1e-12 * largest;  // of rounding
    text += (text.size() > 1 ? ", " : "") + number_text(noise ? 0.0 : x);
  }
  return text + ")";
}

/// "1 edge", "2 edges", "2 half-edges"
std::string plural(std::size_t count, std::string_view noun);

}  // namespace meshgrade
