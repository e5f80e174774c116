#include "grader/similarity/code_tokens.h"

#include <cctype>
#include <set>
#include <string>

#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

/// Letters beyond ASCII count as such, whatever they are: a sequence of bytes stays whole.
bool is_word(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || c == '_' || byte >= 0x80;
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

const std::set<std::string_view>& keywords() {
  static const std::set<std::string_view> words{
      "auto",      "bool",     "break",    "case",   "char",   "class",  "const",
      "constexpr", "continue", "default",  "delete", "do",     "double", "else",
      "enum",      "false",    "float",    "for",    "if",     "inline", "int",
      "long",      "new",      "operator", "return", "size_t", "sizeof", "static",
      "struct",    "switch",   "template", "this",   "throw",  "true",   "try",
      "typename",  "using",    "unsigned", "void",   "while"};
  return words;
}

/// FNV-1a.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (char c : text)
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

/// Numbers with their points and exponents; "1e-5" is one.
std::size_t number_end(std::string_view code, std::size_t at) {
  while (at < code.size() && (is_word(code[at]) || code[at] == '.')) {
    const bool exponent = code[at] == 'e' || code[at] == 'E';
    ++at;
    if (exponent && at < code.size() && (code[at] == '-' || code[at] == '+')) ++at;
  }
  return at;
}

std::size_t token_end(std::string_view code, std::size_t at) {
  if (is_digit(code[at]) || (code[at] == '.' && at + 1 < code.size() && is_digit(code[at + 1])))
    return number_end(code, at);
  if (is_word(code[at])) {
    while (at < code.size() && is_word(code[at]))
      ++at;
    return at;
  }
  const std::string_view two = code.substr(at, 2);
  return at + (two == "->" || two == "::" ? 2 : 1);
}

}  // namespace

std::vector<CodeToken> code_tokens(std::string_view text) {
  const std::string blanked = code_only(text);
  const std::string_view code = blanked;
  std::vector<CodeToken> tokens;
  std::string_view before;
  for (std::size_t at = 0; at < code.size();) {
    if (std::isspace(static_cast<unsigned char>(code[at])) != 0) {
      ++at;
      continue;
    }
    const std::size_t end = token_end(code, at);
    const std::string_view token = code.substr(at, end - at);
    const bool is_name = is_word(token[0]) && !is_digit(token[0]);
    const bool is_member = before == "." || before == "->" || before == "::";
    const bool is_chosen = is_name && !is_member && keywords().count(token) == 0;
    tokens.push_back({hash_of(is_chosen ? "name" : token), at, end});
    before = token;
    at = end;
  }
  return tokens;
}

}  // namespace meshgrade
