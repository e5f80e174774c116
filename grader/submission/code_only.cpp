#include "grader/submission/code_only.h"

#include <algorithm>
#include <cctype>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

class Blanker {
 public:
  explicit Blanker(std::string_view text) : text_(text), code_(text) {}

  std::string blank_all() {
    while (at_ < text_.size())
      step();
    return std::move(code_);
  }

 private:
  bool follows(std::string_view part) const { return text_.substr(at_, part.size()) == part; }

  void step() {
    const char c = text_[at_];
    if (follows("//")) {
      blank_to(line_end(at_));
    } else if (follows("/*")) {
      blank_to(after("*/", at_ + 2));
    } else if (c == '#' && line_is_empty_so_far_) {
      blank_directive();
    } else if (c == '"') {
      is_raw() ? blank_raw_string() : blank_quoted('"');
    } else if (c == '\'' && !is_digit_separator()) {
      blank_quoted('\'');
    } else {
      if (c == '\n') {
        line_is_empty_so_far_ = true;
      } else if (std::isspace(static_cast<unsigned char>(c)) == 0) {
        line_is_empty_so_far_ = false;
      }
      ++at_;
    }
  }

  void blank_to(std::size_t end) {
    for (; at_ < std::min(end, text_.size()); ++at_) {
      if (code_[at_] != '\n') code_[at_] = ' ';
    }
  }

  /// The first place behind `mark`, or the end of the text.
  std::size_t after(std::string_view mark, std::size_t from) const {
    const std::size_t found = text_.find(mark, from);
    return found == std::string_view::npos ? text_.size() : found + mark.size();
  }

  /// Where the line ends, lines that a backslash continues taken together.
  std::size_t line_end(std::size_t from) const {
    for (std::size_t end = text_.find('\n', from); end != std::string_view::npos;
         end = text_.find('\n', end + 1)) {
      const std::size_t last = end > 0 && text_[end - 1] == '\r' ? end - 1 : end;
      if (last == 0 || text_[last - 1] != '\\') return end;
    }
    return text_.size();
  }

  /// Up to the end of the line, or to a comment, which may go on in the next line.
  void blank_directive() {
    const std::size_t end = line_end(at_);
    const std::size_t comment = text_.substr(at_, end - at_).find("/*");
    blank_to(comment == std::string_view::npos ? end : at_ + comment);
  }

  void blank_quoted(char quote) {
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != quote && text_[end] != '\n') {
      end += text_[end] == '\\' ? 2 : 1;
    }
    const bool closed = end < text_.size() && text_[end] == quote;
    blank_to(closed ? end + 1 : end);
    line_is_empty_so_far_ = false;
  }

  /// R"(...)", also with one of the prefixes u8, u, U, L.
  bool is_raw() const {
    if (at_ == 0 || text_[at_ - 1] != 'R') return false;
    std::size_t start = at_ - 1;
    while (start > 0 && is_word_character(text_[start - 1]))
      --start;
    const std::string_view prefix = text_.substr(start, at_ - 1 - start);
    return prefix.empty() || prefix == "u8" || prefix == "u" || prefix == "U" || prefix == "L";
  }

  void blank_raw_string() {
    const std::size_t open = text_.find('(', at_);
    if (open == std::string_view::npos) return blank_to(text_.size());
    const std::string delimiter(text_.substr(at_ + 1, open - at_ - 1));
    blank_to(after(")" + delimiter + "\"", open));
    line_is_empty_so_far_ = false;
  }

  /// 1'000'000
  bool is_digit_separator() const {
    return at_ > 0 && std::isdigit(static_cast<unsigned char>(text_[at_ - 1])) != 0;
  }

  std::string_view text_;
  std::string code_;
  std::size_t at_ = 0;
  bool line_is_empty_so_far_ = true;
};

}  // namespace

std::string code_only(std::string_view text) {
  return Blanker(text).blank_all();
}

}  // namespace meshgrade
