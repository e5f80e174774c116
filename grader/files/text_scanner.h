#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// Walks over a text file line by line and word by word, and knows the line for messages.
/// Words are separated by blanks; '#' starts a comment in most formats. A line ends with LF, CR
/// LF or, as on old Macs, CR. Every fault is a UserError with "<file>:<line>:" in front.
class TextScanner {
 public:
  TextScanner(std::filesystem::path file, std::string_view text, bool has_comments = true)
      : file_(std::move(file)), text_(text), size_(text.size()), has_comments_(has_comments) {}

  /// Goes to the next line that holds a word. False at the end of the text.
  bool next_line();
  /// As next_line, but the text must not end here; `expected` says what is missing.
  void require_line(const std::string& expected);
  /// Goes on to the next lines until there is a word, for formats in which words may stand on
  /// any line. The text must not end here.
  void require_word(const std::string& expected);

  /// The next word of this line, empty at the end of the line.
  std::string_view next_word();
  /// What next_word gave last, also on the way to a number.
  std::string_view last_word() const { return last_word_; }
  bool has_word() const;
  std::size_t count_words() const;
  /// A finite number that single precision can hold, too.
  double next_number(const std::string& expected);
  Point3 next_point(const std::string& expected);
  /// A whole number from -2^31 to 2^32 - 1.
  std::int64_t next_integer(const std::string& expected);
  std::uint32_t next_index(const std::string& expected);
  /// As next_number and next_integer, but say false and stay where they are instead of
  /// refusing: then the words of a message need not be made for each number.
  bool try_number(double& number);
  bool try_integer(std::int64_t& number);
  /// Refuses anything that is left on this line.
  void end_line();

  /// Where the next line begins, in bytes from the start of the text.
  std::size_t offset() const { return size_ - text_.size(); }
  std::string place() const { return std::to_string(line_); }
  const std::filesystem::path& file() const { return file_; }
  [[noreturn]] void refuse(const std::string& what) const;

 private:
  std::filesystem::path file_;
  std::string_view text_;
  std::size_t size_;
  std::string_view rest_of_line_;
  std::string_view last_word_;
  std::size_t line_ = 0;
  bool has_comments_;
};

/// A finite number that single precision can hold, from the whole of `word`, in the locale of
/// no country. False if it is anything else.
bool parse_number(std::string_view word, double& number);

/// A whole number, from the whole of `word`.
bool parse_integer(std::string_view word, std::int64_t& number);

/// Takes the first line, without its end, off `text`.
std::string_view take_line(std::string_view& text);

}  // namespace meshgrade
