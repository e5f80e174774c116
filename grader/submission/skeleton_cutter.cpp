#include "grader/submission/skeleton_cutter.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <utility>
#include <vector>

#include "grader/base/errors.h"

namespace meshgrade {

namespace {

constexpr std::string_view kMark = "// SOLUTION";
constexpr std::string_view kBegin = "// SOLUTION BEGIN";
constexpr std::string_view kEnd = "// SOLUTION END";
constexpr std::string_view kSpaces = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpaces);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

bool is_blank(std::string_view line) {
  return trimmed(line).empty();
}

/// Lines with their line ends, so that joining them gives the same text again.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::size_t size = end == std::string_view::npos ? text.size() : end + 1;
    lines.push_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return lines;
}

bool is_function_name(std::string_view name) {
  return std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == ':';
  });
}

class Cutter {
 public:
  Cutter(std::string_view source, const std::string& file_name)
      : lines_(lines_of(source)), file_name_(file_name) {}

  std::string cut() {
    for (at_ = 0; at_ < lines_.size(); ++at_) {
      const std::string_view line = lines_[at_];
      if (line.find(kMark) == std::string_view::npos) {
        keep(line);
      } else if (trimmed(line).substr(0, kBegin.size()) == kBegin) {
        cut_part();
      } else {
        refuse_stray_mark();
      }
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw GraderError(file_name_ + ":" + std::to_string(at_ + 1) + ": " + what);
  }

  [[noreturn]] void refuse_stray_mark() const {
    if (trimmed(lines_[at_]) == kEnd) refuse("SOLUTION END without a SOLUTION BEGIN");
    refuse(
        "this is no mark; a mark is a line of its own, \"// SOLUTION BEGIN <function>\" or "
        "\"// SOLUTION END\"");
  }

  void keep(std::string_view line) {
    last_is_blank_ = is_blank(line);
    result_ += line;
  }

  void cut_part() {
    const std::string_view begin = lines_[at_];
    const std::string_view rest = trimmed(begin).substr(kBegin.size());
    const std::string_view name = trimmed(rest);
    const std::string_view indent = begin.substr(0, begin.find(kBegin));
    if ((!rest.empty() && rest.front() != ' ') || !is_function_name(name)) refuse_stray_mark();
    if (indent.empty() && !name.empty()) {
      refuse("a part with a name is the body of a function and must be indented");
    }
    if (!indent.empty() && name.empty()) {
      refuse("SOLUTION BEGIN inside a function must name the function");
    }
    skip_to_end();
    if (name.empty()) {
      const bool blank_follows = at_ + 1 < lines_.size() && is_blank(lines_[at_ + 1]);
      if (last_is_blank_ && blank_follows) ++at_;
    } else {
      put_stub(indent, name);
    }
  }

  /// Leaves `at_` at the END that belongs to the BEGIN where it is.
  void skip_to_end() {
    const std::size_t begin = at_;
    for (++at_; at_ < lines_.size(); ++at_) {
      const std::string_view line = lines_[at_];
      if (line.find(kMark) == std::string_view::npos) continue;
      if (trimmed(line) == kEnd) return;
      if (trimmed(line).substr(0, kBegin.size()) != kBegin) refuse_stray_mark();
      refuse("SOLUTION BEGIN inside the part that begins at line " + std::to_string(begin + 1));
    }
    at_ = begin;
    refuse("SOLUTION BEGIN without a SOLUTION END");
  }

  void put_stub(std::string_view indent, std::string_view name) {
    result_ += indent;
    result_ += "// TODO: your code goes here. Delete the next line when you start.\n";
    result_ += indent;
    result_ += "notImplemented(\"" + std::string(name) + "\");\n";
    last_is_blank_ = false;
  }

  std::vector<std::string_view> lines_;
  const std::string& file_name_;
  std::size_t at_ = 0;
  bool last_is_blank_ = true;  // the start of the file counts as an empty line
  std::string result_;
};

}  // namespace

std::string cut_solution(std::string_view source, const std::string& file_name) {
  return Cutter(source, file_name).cut();
}

}  // namespace meshgrade
