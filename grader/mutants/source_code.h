#pragma once

// A solution as far as a mutator must understand it: tokens, functions, simple statements, loop
// and branch headers, and the names that are declared. Not a C++ parser: it relies on code that
// clang-format has laid out (spaces around binary operators) and that compiles.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meshgrade {

enum class TokenKind { kWord, kNumber, kSymbol };

struct Token {
  TokenKind kind = TokenKind::kSymbol;
  std::string_view text;
  std::size_t at = 0;     ///< place of its first character in the text
  bool is_open = false;   ///< lies between SOLUTION marks: may be changed
  std::size_t match = 0;  ///< of a bracket: the token of its partner

  bool is(std::string_view other) const { return text == other; }
};

/// Tokens `first` to `last`, both included.
struct Span {
  std::size_t first = 0;
  std::size_t last = 0;
};

struct Function {
  std::string name;  ///< without its class: "flipEdge"
  bool is_void = false;
  Span parameters;  ///< with parentheses
  Span body;        ///< with braces
};

/// `if (...)`, `for (...)`, `while (...)`.
struct Header {
  std::size_t keyword = 0;
  Span condition;  ///< with parentheses
  bool is_end_of_do = false;
};

struct Declaration {
  std::string type;  ///< without const and &
  std::size_t name = 0;
  std::size_t scope_end = 0;
};

class SourceCode {
 public:
  explicit SourceCode(std::string text);
  SourceCode(const SourceCode&) = delete;
  SourceCode& operator=(const SourceCode&) = delete;

  const std::string& text() const { return text_; }
  const std::vector<Token>& tokens() const { return tokens_; }
  const std::vector<Function>& functions() const { return functions_; }
  const std::vector<Span>& statements() const { return statements_; }  ///< up to their `;`
  const std::vector<Header>& headers() const { return headers_; }
  const std::vector<Declaration>& declarations() const { return declarations_; }

  bool is_open(Span span) const {
    return tokens_[span.first].is_open && tokens_[span.last].is_open;
  }
  const Function* function_at(std::size_t token) const;
  /// Whether the statement declares a variable.
  bool is_declaration(Span statement) const;
  /// The characters of a span of tokens.
  std::string_view text_of(Span span) const;
  /// The top-level parts of what is in parentheses, between commas.
  std::vector<Span> arguments(Span parentheses) const;

 private:
  void read_tokens();
  void match_brackets();
  void find_functions();
  void read_body(const Function& function);
  std::size_t read_header(std::size_t at, bool after_block);
  void read_parameters(const Function& function);
  void add_declaration(std::size_t first, std::size_t scope_end);
  std::size_t end_of_type(std::size_t first) const;

  std::string text_;
  std::vector<Token> tokens_;
  std::vector<Function> functions_;
  std::vector<Span> statements_;
  std::vector<Header> headers_;
  std::vector<Declaration> declarations_;
};

}  // namespace meshgrade
