#include "grader/files/text_scanner.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "grader/files/file_bytes.h"

namespace meshgrade {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

/// std::from_chars takes no plus sign, but files have them.
std::string_view without_plus(std::string_view word) {
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
  return has_plus ? word.substr(1) : word;
}

template <typename Number>
bool parse_whole(std::string_view word, Number& number) {
  word = without_plus(word);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  return error == std::errc() && stop == end;
}

}  // namespace

bool parse_number(std::string_view word, double& number) {
  return parse_whole(word, number) && std::isfinite(number) &&
         std::abs(number) <= std::numeric_limits<float>::max();
}

bool parse_integer(std::string_view word, std::int64_t& number) {
  return parse_whole(word, number);
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  const std::size_t n_ends = text.substr(end).starts_with("\r\n") ? 2 : 1;
  text.remove_prefix(std::min(end + n_ends, text.size()));
  return line;
}

bool TextScanner::next_line() {
  while (!text_.empty()) {
    ++line_;
    rest_of_line_ = take_line(text_);
    if (has_comments_) rest_of_line_ = rest_of_line_.substr(0, rest_of_line_.find('#'));
    if (has_word()) return true;
  }
  return false;
}

void TextScanner::require_line(const std::string& expected) {
  if (!next_line()) {
    refuse("the file ends where " + expected + " should follow; it may be cut off");
  }
}

void TextScanner::require_word(const std::string& expected) {
  if (!has_word()) require_line(expected);
}

std::string_view TextScanner::next_word() {
  const std::size_t begin =
      std::min(rest_of_line_.find_first_not_of(kBlanks), rest_of_line_.size());
  rest_of_line_.remove_prefix(begin);
  last_word_ = rest_of_line_.substr(0, rest_of_line_.find_first_of(kBlanks));
  rest_of_line_.remove_prefix(last_word_.size());
  return last_word_;
}

bool TextScanner::has_word() const {
  return rest_of_line_.find_first_not_of(kBlanks) != std::string_view::npos;
}

std::size_t TextScanner::count_words() const {
  TextScanner ahead = *this;
  std::size_t n_words = 0;
  while (!ahead.next_word().empty())
    ++n_words;
  return n_words;
}

bool TextScanner::try_number(double& number) {
  const std::string_view before = rest_of_line_;
  if (parse_number(next_word(), number)) return true;
  rest_of_line_ = before;
  return false;
}

bool TextScanner::try_integer(std::int64_t& number) {
  const std::string_view before = rest_of_line_;
  if (parse_integer(next_word(), number) &&
      number >= std::numeric_limits<std::int32_t>::min() &&
      number <= std::numeric_limits<std::uint32_t>::max()) {
    return true;
  }
  rest_of_line_ = before;
  return false;
}

double TextScanner::next_number(const std::string& expected) {
  double number = 0;
  if (try_number(number)) return number;
  const std::string_view word = next_word();
  if (word.empty()) refuse("the line ends where " + expected + " should follow");
  refuse(in_quotes(word) + " where " + expected +
         " should be; coordinates are finite numbers up to 3.4e38");
}

Point3 TextScanner::next_point(const std::string& expected) {
  Point3 point{};
  for (double& coordinate : point)
    coordinate = next_number(expected);
  return point;
}

std::int64_t TextScanner::next_integer(const std::string& expected) {
  std::int64_t number = 0;
  if (try_integer(number)) return number;
  const std::string_view word = next_word();
  if (word.empty()) refuse("the line ends where " + expected + " should follow");
  refuse(in_quotes(word) + " where " + expected + " should be; write a whole number");
}

std::uint32_t TextScanner::next_index(const std::string& expected) {
  const std::int64_t number = next_integer(expected);
  if (number < 0) refuse(expected + " is " + std::to_string(number) + ", below zero");
  return static_cast<std::uint32_t>(number);
}

void TextScanner::end_line() {
  const std::string_view word = next_word();
  if (!word.empty()) refuse(in_quotes(word) + " after the end of the line's data; remove it");
}

void TextScanner::refuse(const std::string& what) const {
  refuse_file(file_, place(), what);
}

}  // namespace meshgrade
