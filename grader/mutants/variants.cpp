#include "grader/mutants/variants.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "grader/base/pattern.h"
#include "grader/base/text.h"
#include "grader/mutants/source_code.h"

namespace meshgrade {
namespace {

using Lines = std::vector<std::string>;

bool toss(Random& random) {
  return random.below(2) == 1;
}

/// The library's shuffle differs between machines.
template <class T>
void shuffle(std::vector<T>& list, Random& random) {
  for (std::size_t i = list.size(); i > 1; --i) {
    std::swap(list[i - 1], list[random.below(static_cast<std::uint32_t>(i))]);
  }
}

std::string join_lines(const Lines& lines) {
  return join(lines, "\n") + "\n";
}

/// Calls `change` for each run of lines that match the form.
void for_each_run(Lines& lines, const Pattern& form,
                  const std::function<void(std::size_t first, std::size_t end)>& change) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::size_t end = i;
    while (end < lines.size() && form.matches(lines[end]))
      ++end;
    if (end > i) change(i, end);
    i = std::max(i, end);
  }
}

/// `const HalfedgeIter bm = h;` and its neighbours of the same type exchange their values.
std::string exchange_parts(const std::string& text, Random& random) {
  static const Pattern declaration(
      R"((\s*const (?:Halfedge|Edge|Face)Iter \w+ = )((?:\w+\.)?new\w+\(\)|\w+)(;))");
  Lines lines = split_lines(text);
  const auto type = [](const std::string& line) { return line.substr(0, line.find("Iter")); };
  for_each_run(lines, declaration, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end;) {
      std::size_t last = i;
      std::vector<std::string> values;
      Pattern::Groups match;
      for (; last < end && type(lines[last]) == type(lines[i]); ++last) {
        declaration.matches(lines[last], match);
        values.push_back(match[2]);
      }
      shuffle(values, random);
      for (std::size_t k = 0; k < values.size(); ++k) {
        std::string& line = lines[i + k];
        line = line.substr(0, line.find(" = ")) + " = " + values[k] + ";";
      }
      i = last;
    }
  });
  return join_lines(lines);
}

/// Lines that only set pointers to variables, each another one, may come in any order.
std::string reorder_assignments(const std::string& text, Random& random) {
  static const Pattern assignment(
      R"(\s*\w+->(?:setNeighbors\(\w+(?:, \w+){4}\)|\w+\(\) = \w+);)");
  Lines lines = split_lines(text);
  for_each_run(lines, assignment, [&](std::size_t first, std::size_t end) {
    Lines run(lines.begin() + static_cast<std::ptrdiff_t>(first),
              lines.begin() + static_cast<std::ptrdiff_t>(end));
    shuffle(run, random);
    std::copy(run.begin(), run.end(), lines.begin() + static_cast<std::ptrdiff_t>(first));
  });
  return join_lines(lines);
}

std::string single_assignments(const std::string& text, Random& random) {
  static const Pattern call(
      R"((\s*)(\w+)->setNeighbors\(([^,]+), ([^,]+), ([^,]+), ([^,]+), ([^,]+)\);)");
  static const char* const members[] = {"next", "twin", "vertex", "edge", "face"};
  Lines lines;
  for (const std::string& line : split_lines(text)) {
    Pattern::Groups match;
    if (!call.matches(line, match) || random.below(3) != 0) {
      lines.push_back(line);
      continue;
    }
    Lines parts;
    for (std::size_t i = 0; i < 5; ++i) {
      parts.push_back(match[1] + match[2] + "->" + members[i] + "() = " + match[i + 3] + ";");
    }
    shuffle(parts, random);
    lines.insert(lines.end(), parts.begin(), parts.end());
  }
  return join_lines(lines);
}

/// The half-edges that an element may anchor, by its name: any of `ab`, `bd`, `da` for
/// `face_abd`, `ab` or `ba` for `edge_ab`, all that begin with b for `b`. The midpoint of a
/// split anchors one along the old edge, towards b or c.
bool may_anchor(const std::string& element, std::string_view halfedge) {
  if (halfedge.size() != 2) return false;
  const std::string pair(halfedge);
  if (element.size() == 1) {
    return pair[0] == element[0] && (element != "m" || pair[1] == 'b' || pair[1] == 'c');
  }
  const std::string corners = element.substr(5);
  if (element[0] == 'f') return (corners + corners[0]).find(pair) != std::string::npos;
  return corners == pair || corners == std::string(pair.rbegin(), pair.rend());
}

std::string choose_anchors(const std::string& text, Random& random) {
  const SourceCode code(text);
  static const Pattern anchor(R"((\w|edge_\w\w|face_\w\w\w)->halfedge\(\) = (\w\w);)");
  std::string result = text;
  std::ptrdiff_t shift = 0;
  for (Span statement : code.statements()) {
    const std::string line(code.text_of(statement));
    Pattern::Groups match;
    if (!code.is_open(statement) || !anchor.matches(line, match)) continue;
    std::vector<std::string> choices;
    for (const Declaration& d : code.declarations()) {
      const Token& name = code.tokens()[d.name];
      const bool visible = d.name < statement.first && statement.first < d.scope_end &&
                           code.function_at(d.name) == code.function_at(statement.first);
      if (visible && d.type == "HalfedgeIter" && may_anchor(match[1], name.text)) {
        choices.emplace_back(name.text);
      }
    }
    if (choices.empty()) continue;
    const std::string& chosen =
        choices[random.below(static_cast<std::uint32_t>(choices.size()))];
    const std::string other = line.substr(0, line.find("= ")) + "= " + chosen + ";";
    const auto at = static_cast<std::ptrdiff_t>(code.tokens()[statement.first].at) + shift;
    result.replace(static_cast<std::size_t>(at), line.size(), other);
    shift +=
        static_cast<std::ptrdiff_t>(other.size()) - static_cast<std::ptrdiff_t>(line.size());
  }
  return result;
}

bool ends_term(const Token& token) {
  static const std::set<std::string_view> ends{";", ",", ")", "]", "+", "-", "<", "}"};
  return ends.count(token.text) != 0;
}

bool begins_sum(const Token& token) {
  static const std::set<std::string_view> begins{"=", "+=", "(", ",", "[", "return", "<", ";"};
  return begins.count(token.text) != 0;
}

/// `x + y` becomes `y + x` at one `+`.
std::string commute(const SourceCode& code, std::size_t plus) {
  const auto& tokens = code.tokens();
  std::size_t first = plus - 1;
  for (;; --first) {
    if (tokens[first].is(")") || tokens[first].is("]")) first = tokens[first].match;
    if (begins_sum(tokens[first - 1])) break;
  }
  std::size_t last = plus + 1;
  for (;; ++last) {
    if (tokens[last].is("(") || tokens[last].is("[")) last = tokens[last].match;
    if (ends_term(tokens[last + 1])) break;
  }
  const std::string_view left = code.text_of({first, plus - 1});
  const std::string_view right = code.text_of({plus + 1, last});
  std::string text = code.text();
  text.replace(tokens[first].at, code.text_of({first, last}).size(),
               std::string(right) + " + " + std::string(left));
  return text;
}

std::string commute_sums(std::string text, Random& random) {
  for (int round = 0; round < 4; ++round) {
    const SourceCode code(text);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < code.tokens().size(); ++i) {
      if (code.tokens()[i].is_open && code.tokens()[i].is("+")) places.push_back(i);
    }
    if (places.empty()) return text;
    text = commute(code, places[random.below(static_cast<std::uint32_t>(places.size()))]);
  }
  return text;
}

using Renaming = std::function<std::string(const SourceCode& code, std::size_t token)>;

/// Replaces words of the open parts; an empty string keeps the word.
std::string replace_words(const std::string& text, const Renaming& renaming) {
  const SourceCode code(text);
  std::string result;
  std::size_t done = 0;
  for (std::size_t i = 0; i < code.tokens().size(); ++i) {
    const Token& token = code.tokens()[i];
    if (!token.is_open || token.kind != TokenKind::kWord) continue;
    const std::string other = renaming(code, i);
    if (other.empty()) continue;
    result += text.substr(done, token.at - done) + other;
    done = token.at + token.text.size();
  }
  return result + text.substr(done);
}

std::string compute_in_float(const std::string& text) {
  return replace_words(text, [](const SourceCode& code, std::size_t i) {
    const Token& before = code.tokens()[i - 1];
    return code.tokens()[i].is("double") && !before.is("<") ? "float" : "";
  });
}

/// Gives every variable and helper function of the solution another name.
std::string rename_everything(const std::string& text, Random& random) {
  const SourceCode code(text);
  std::map<std::string, std::string, std::less<>> names;
  std::set<std::string, std::less<>> fixed;
  for (const Declaration& d : code.declarations()) {
    const Token& name = code.tokens()[d.name];
    if (!name.is_open) fixed.emplace(name.text);
    names.emplace(name.text, "");
  }
  for (const Function& function : code.functions()) {
    if (code.tokens()[function.parameters.first].is_open) names.emplace(function.name, "");
  }
  std::uint32_t number = random.below(100);
  for (auto& [name, other] : names) {
    if (fixed.count(name) == 0) other = "my_" + name.substr(0, 1) + std::to_string(++number);
  }
  return replace_words(text, [&](const SourceCode& same, std::size_t i) -> std::string {
    const Token& before = same.tokens()[i - 1];
    if (before.is("->") || before.is(".") || before.is("::")) return "";
    const auto found = names.find(same.tokens()[i].text);
    return found == names.end() ? "" : found->second;
  });
}

}  // namespace

std::string make_variant(const std::string& solution, Random& random) {
  std::string text = exchange_parts(solution, random);
  text = choose_anchors(text, random);
  text = single_assignments(reorder_assignments(text, random), random);
  text = commute_sums(text, random);
  if (toss(random)) text = compute_in_float(text);
  if (toss(random)) text = rename_everything(text, random);
  return text;
}

}  // namespace meshgrade
