#include "grader/report/endless_loop.h"

#include <algorithm>
#include <vector>

#include "grader/base/pattern.h"
#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

/// Reads loops out of a text without comments and strings.
class LoopReader {
 public:
  explicit LoopReader(const std::string& text) : text_(text) {}

  struct Loop {
    EnclosingLoop told;
    int first = 0;
    int last = 0;  ///< of its lines
  };

  std::vector<Loop> read() const {
    static const Pattern keyword(R"(\b(for|while|do)\b)");
    std::vector<Loop> loops;
    for (const auto& [at, size] : keyword.places_in(text_)) {
      const std::string word = text_.substr(at, size);
      loops.push_back(word == "do" ? read_do(at, at + size)
                                   : read_head(word == "for", at, at + size));
    }
    return loops;
  }

 private:
  Loop read_head(bool is_for, std::size_t at, std::size_t after) const {
    const std::size_t open = skip_space(after);
    const std::size_t body = after_pair(open, '(', ')');
    Loop loop;
    loop.told.line = loop.first = line_of(at);
    loop.told.counts = is_for && has_condition(text_.substr(open, body - open));
    loop.last = line_of(end_of_statement(body));
    return loop;
  }

  /// The condition of "do ... while" stands at the end.
  Loop read_do(std::size_t at, std::size_t after) const {
    const std::size_t end = end_of_statement(after);
    const std::size_t condition = text_.find("while", end);
    Loop loop;
    loop.first = line_of(at);
    loop.told.line = condition == std::string::npos ? loop.first : line_of(condition);
    loop.last = std::max(line_of(end), loop.told.line);
    return loop;
  }

  /// "(int i = 0; i < n; ++i)" or "(const auto& row : rows)", but not "(;;)".
  static bool has_condition(const std::string& head) {
    const std::size_t first = head.find(';');
    if (first == std::string::npos) return true;
    const std::size_t second = head.find(';', first + 1);
    return head.substr(first + 1, second - first - 1).find_first_not_of(" \t\n") !=
           std::string::npos;
  }

  std::size_t skip_space(std::size_t at) const {
    return std::min(text_.find_first_not_of(" \t\r\n", at), text_.size());
  }

  /// The place after the bracket that closes the one at `at`.
  std::size_t after_pair(std::size_t at, char open, char close) const {
    int depth = 0;
    for (; at < text_.size(); ++at) {
      if (text_[at] == open) ++depth;
      if (text_[at] == close && --depth <= 0) return at + 1;
    }
    return text_.size();
  }

  /// The end of a block, or of one statement, which may hold blocks.
  std::size_t end_of_statement(std::size_t at) const {
    at = skip_space(at);
    if (at < text_.size() && text_[at] == '{') return after_pair(at, '{', '}') - 1;
    for (; at < text_.size() && text_[at] != ';'; ++at) {
      if (text_[at] == '(') at = after_pair(at, '(', ')') - 1;
      if (text_[at] == '{') return after_pair(at, '{', '}') - 1;
    }
    return at;
  }

  int line_of(std::size_t at) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at, text_.size()));
    return 1 + static_cast<int>(std::count(text_.begin(), end, '\n'));
  }

  const std::string& text_;
};

}  // namespace

std::optional<EnclosingLoop> enclosing_loop(const std::string& source, int line) {
  const std::string text = code_only(source);
  std::optional<LoopReader::Loop> best;
  for (const LoopReader::Loop& loop : LoopReader(text).read()) {
    if (line < loop.first || line > loop.last) continue;
    const bool better = !best || (best->told.counts && !loop.told.counts) ||
                        (best->told.counts == loop.told.counts &&
                         loop.last - loop.first <= best->last - best->first);
    if (better) best = loop;
  }
  if (!best) return std::nullopt;
  return best->told;
}

}  // namespace meshgrade
