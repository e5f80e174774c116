#include "grader/mutants/source_code.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "grader/base/errors.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace {

constexpr std::array<std::string_view, 14> kLongSymbols{
    "->", "++", "--", "+=", "-=", "*=", "/=", "==", "!=", "<=", ">=", "&&", "||", "::"};

std::size_t symbol_length(std::string_view rest) {
  for (std::string_view symbol : kLongSymbols) {
    if (rest.substr(0, symbol.size()) == symbol) return symbol.size();
  }
  return 1;
}

std::size_t word_length(std::string_view rest, bool number) {
  std::size_t size = 1;
  while (size < rest.size() &&
         (is_word_character(rest[size]) || (number && rest[size] == '.'))) {
    ++size;
  }
  return size;
}

/// The end of a string literal or an `#include` line, which hold nothing to change.
std::size_t end_of_skipped(std::string_view text, std::size_t at) {
  const char end = text[at] == '"' ? '"' : '\n';
  const std::size_t found = text.find(end, at + 1);
  return found == std::string_view::npos ? text.size() : found + 1;
}

bool is_statement_word(const Token& token) {
  return token.is("return") || token.is("continue") || token.is("break");
}

}  // namespace

SourceCode::SourceCode(std::string text) : text_(std::move(text)) {
  read_tokens();
  match_brackets();
  find_functions();
  for (const Function& function : functions_) {
    read_parameters(function);
    read_body(function);
  }
}

void SourceCode::read_tokens() {
  const std::string_view text = text_;
  bool open = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    if (rest.substr(0, 2) == "//") {
      if (rest.substr(0, 17) == "// SOLUTION BEGIN") open = true;
      if (rest.substr(0, 15) == "// SOLUTION END") open = false;
      at = std::min(text.size(), text.find('\n', at));
    } else if (std::isspace(static_cast<unsigned char>(text[at])) != 0) {
      ++at;
    } else if (text[at] == '"' || text[at] == '#') {
      at = end_of_skipped(text, at);
    } else {
      const bool number = std::isdigit(static_cast<unsigned char>(text[at])) != 0;
      const bool word = is_word_character(text[at]);
      const std::size_t size = word ? word_length(rest, number) : symbol_length(rest);
      const TokenKind kind = number ? TokenKind::kNumber
                             : word ? TokenKind::kWord
                                    : TokenKind::kSymbol;
      tokens_.push_back({kind, rest.substr(0, size), at, open, 0});
      at += size;
    }
  }
}

void SourceCode::match_brackets() {
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    const Token& token = tokens_[i];
    if (token.is("(") || token.is("[") || token.is("{")) waiting.push_back(i);
    if (!token.is(")") && !token.is("]") && !token.is("}")) continue;
    if (waiting.empty()) throw GraderError("a bracket is closed that was never opened");
    tokens_[i].match = waiting.back();
    tokens_[waiting.back()].match = i;
    waiting.pop_back();
  }
}

/// A function is `name(parameters) {` or `name(parameters) const {` in a namespace.
void SourceCode::find_functions() {
  for (std::size_t i = 2; i < tokens_.size(); ++i) {
    if (!tokens_[i].is("{")) continue;
    const std::size_t close = tokens_[i - 1].is("const") ? i - 2 : i - 1;
    if (!tokens_[close].is(")")) continue;
    const std::size_t open = tokens_[close].match;
    std::size_t first = open - 1;
    while (first >= 2 && tokens_[first - 1].is("::"))
      first -= 2;
    functions_.push_back({std::string(tokens_[open - 1].text),
                          first > 0 && tokens_[first - 1].is("void"),
                          {open, close},
                          {i, tokens_[i].match}});
    i = tokens_[i].match;
  }
}

void SourceCode::read_parameters(const Function& function) {
  for (Span parameter : arguments(function.parameters)) {
    add_declaration(parameter.first, function.body.last);
  }
}

void SourceCode::read_body(const Function& function) {
  std::vector<std::size_t> scope_ends{function.body.last};
  bool after_do = false;
  for (std::size_t i = function.body.first + 1; i < function.body.last;) {
    const Token& token = tokens_[i];
    if (token.is("{")) {
      scope_ends.push_back(token.match);
      ++i;
    } else if (token.is("}")) {
      scope_ends.pop_back();
      after_do = token.match > 0 && tokens_[token.match - 1].is("do");
      ++i;
    } else if (token.is("if") || token.is("for") || token.is("while")) {
      i = read_header(i, after_do);
      after_do = false;
    } else if (token.is("do") || token.is("else") || token.is(";")) {
      ++i;
    } else {
      std::size_t last = i;
      while (!tokens_[last].is(";")) {
        last =
            tokens_[last].is("(") || tokens_[last].is("{") ? tokens_[last].match + 1 : last + 1;
      }
      statements_.push_back({i, last});
      add_declaration(i, scope_ends.back());
      i = last + 1;
    }
  }
}

std::size_t SourceCode::read_header(std::size_t at, bool after_block) {
  const std::size_t open = at + 1;
  const std::size_t close = tokens_[open].match;
  headers_.push_back({at, {open, close}, after_block && tokens_[at].is("while")});
  std::size_t scope_end = close + 1;
  if (tokens_[scope_end].is("{")) scope_end = tokens_[scope_end].match;
  if (tokens_[at].is("for")) add_declaration(open + 1, scope_end);
  return close + 1;
}

/// The token behind a type, or `first` if there is none.
std::size_t SourceCode::end_of_type(std::size_t first) const {
  std::size_t at = first;
  if (tokens_[at].kind != TokenKind::kWord || is_statement_word(tokens_[at])) return first;
  ++at;
  while (tokens_[at].is("::"))
    at += 2;
  if (tokens_[at].is("<") &&
      tokens_[at].at == tokens_[at - 1].at + tokens_[at - 1].text.size()) {
    while (!tokens_[at].is(">"))
      ++at;
    ++at;
  }
  return at;
}

void SourceCode::add_declaration(std::size_t first, std::size_t scope_end) {
  if (tokens_[first].is("const")) ++first;
  const std::size_t end = end_of_type(first);
  const std::size_t name = tokens_[end].is("&") ? end + 1 : end;
  if (end == first || tokens_[name].kind != TokenKind::kWord) return;
  declarations_.push_back({std::string(text_of({first, end - 1})), name, scope_end});
}

const Function* SourceCode::function_at(std::size_t token) const {
  for (const Function& function : functions_) {
    if (function.body.first < token && token < function.body.last) return &function;
  }
  return nullptr;
}

bool SourceCode::is_declaration(Span statement) const {
  return std::any_of(declarations_.begin(), declarations_.end(), [&](const Declaration& d) {
    return statement.first < d.name && d.name <= statement.last;
  });
}

std::string_view SourceCode::text_of(Span span) const {
  const std::size_t begin = tokens_[span.first].at;
  const std::size_t end = tokens_[span.last].at + tokens_[span.last].text.size();
  return std::string_view(text_).substr(begin, end - begin);
}

std::vector<Span> SourceCode::arguments(Span parentheses) const {
  std::vector<Span> parts;
  std::size_t first = parentheses.first + 1;
  for (std::size_t i = first; i <= parentheses.last; ++i) {
    if (tokens_[i].is("(") || tokens_[i].is("[") || tokens_[i].is("{")) i = tokens_[i].match;
    if (!tokens_[i].is(",") && i != parentheses.last) continue;
    if (i > first) parts.push_back({first, i - 1});
    first = i + 1;
  }
  return parts;
}

}  // namespace meshgrade
