#include "grader/build/diagnostics.h"

#include <optional>
#include <utility>

#include "grader/base/pattern.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace {

/// The first line of a message about a place: "a.cpp:30:1: warning: text [-Wname]".
struct Head {
  std::string file;
  int line = 0;
  std::string severity;
  std::string text;
};

std::optional<Head> read_head(const std::string& line) {
  static const Pattern form(
      "([^\\s:][^:]*):([0-9]{1,9})(?::[0-9]+)?: (warning|error|fatal error|note): (.*)");
  Pattern::Groups found;
  if (line.size() > 4000 || !form.matches(line, found)) return std::nullopt;
  return Head{found[1], std::stoi(found[2]), found[3], found[4]};
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() &&
         text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// "In file included from a.h:1," and the lines that go on with it.
bool tells_of_includes(const std::string& line) {
  const std::size_t word = line.find_first_not_of(' ');
  return line.rfind("In file included from ", 0) == 0 ||
         (word != std::string::npos && line.compare(word, 5, "from ") == 0);
}

/// "a.cpp: In function 'int f()':". GCC says it once for all that comes of that function.
bool tells_of_function(const std::string& line) {
  return ends_with(line, ":") &&
         (line.find(": In ") != std::string::npos || ends_with(line, ": At global scope:"));
}

/// A message of the linker, or of the compiler about itself: "/usr/bin/ld: ...".
bool is_of_a_tool(const std::string& line) {
  static const Pattern form("\\S*(ld|collect2|cc1plus|clang[^:]*|[cg]\\+\\+[^:]*)(: .*)");
  return line.size() < 4000 && form.matches(line);
}

}  // namespace

std::vector<CompilerWarning> warnings_in(const std::string& messages) {
  static const Pattern named("(.*) \\[(-W[^\\]]*)\\]");
  std::vector<CompilerWarning> warnings;
  for (const std::string& line : split_lines(messages)) {
    const std::optional<Head> head = read_head(line);
    if (!head || head->severity != "warning") continue;
    Pattern::Groups found;
    const bool has_name = named.matches(head->text, found);
    warnings.push_back(
        {head->file, head->line, has_name ? found[1] : head->text, has_name ? found[2] : ""});
  }
  return warnings;
}

std::string without_warnings(const std::string& messages) {
  std::string kept;
  std::string includes;  // that lead to the next message
  std::string function;  // that it and those after it are about
  bool in_warning = false;
  bool has_error = false;
  for (const std::string& line : split_lines(messages)) {
    if (tells_of_includes(line) || tells_of_function(line)) {
      std::string& told = tells_of_includes(line) ? includes : function;
      told = (&told == &includes ? told : "") + line + "\n";
      in_warning = true;  // the message before is at its end
      continue;
    }
    const std::optional<Head> head = read_head(line);
    if (head && head->severity != "note") {
      in_warning = head->severity == "warning";
      has_error = has_error || !in_warning;
      if (!in_warning) kept += includes + std::exchange(function, "");
      includes.clear();
    } else if (is_of_a_tool(line)) {
      in_warning = false;
    }
    if (!in_warning) kept += line + "\n";
  }
  return has_error ? kept : messages;
}

}  // namespace meshgrade
