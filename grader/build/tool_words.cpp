#include "grader/build/tool_words.h"

#include "grader/base/text.h"

namespace meshgrade {
namespace {

bool begins_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

/// The text between `from` and `to`; empty if they are not there.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from);
  if (start == std::string::npos) return {};
  const std::size_t begin = start + from.size();
  const std::size_t end = text.find(to, begin);
  return end == std::string::npos ? "" : text.substr(begin, end - begin);
}

/// A line of the compiler about itself. What it quotes of the code stands behind a file's name
/// and "error: ", or is indented.
bool tells_of_its_end(const std::string& line) {
  for (const char* words :
       {": internal compiler error: ", ": fatal error: Killed signal terminated program "}) {
    const std::size_t at = line.find(words);
    if (at != std::string::npos && line.substr(0, at).find(' ') == std::string::npos)
      return true;
  }
  return begins_with(line, "PLEASE submit a bug report to ");  // clang's
}

}  // namespace

bool is_dead_compiler(const ProcessResult& result) {
  if (result.ok() || result.stopped()) return false;
  if (result.signal != 0) return true;
  for (const std::string& line : split_lines(result.output)) {
    if (tells_of_its_end(line)) return true;
  }
  return false;
}

std::string explain_link_error(const std::string& messages) {
  for (const std::string& line : split_lines(messages)) {
    const std::string name = between(line, ": multiple definition of `", "'");
    if (name.empty()) continue;
    const std::string where = between(line, "'; ", ": first defined here");
    const std::size_t object = where.find(".o:");
    const std::string file =
        object == std::string::npos ? "the grader" : where.substr(0, object);
    const bool is_ours = file.find(".a(") != std::string::npos;
    return name.substr(0, name.find('(')) + " is defined in " +
           (is_ours ? std::string("the grader") : file) +
           " as well; make one of them static, or rename it";
  }
  return {};
}

}  // namespace meshgrade
