#include "grader/submission/function_extents.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ':' || c == '~';
}

std::string_view first_word(std::string_view chunk) {
  const std::size_t begin = std::min(chunk.find_first_not_of(kSpaces), chunk.size());
  std::size_t end = begin;
  while (end < chunk.size() && is_name_character(chunk[end]))
    ++end;
  return chunk.substr(begin, end - begin);
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Whether a brace behind these words only opens a namespace.
bool opens_namespace(std::string_view chunk) {
  return is_one_of(first_word(chunk), {"namespace", "inline", "extern"}) &&
         chunk.find('(') == std::string_view::npos;
}

bool parentheses_match(std::string_view chunk) {
  return std::count(chunk.begin(), chunk.end(), '(') ==
         std::count(chunk.begin(), chunk.end(), ')');
}

/// The name of the function whose head this is; empty if it is none.
std::string_view function_name(std::string_view chunk) {
  const std::size_t open = chunk.find('(');
  if (open == std::string_view::npos || !parentheses_match(chunk)) return {};
  if (is_one_of(first_word(chunk), {"class", "struct", "union", "enum", "typedef", "using"})) {
    return {};
  }
  const std::string_view before = chunk.substr(0, open);
  if (before.find('=') != std::string_view::npos) return {};  // a variable
  const std::size_t last = before.find_last_not_of(kSpaces);
  if (last == std::string_view::npos) return {};
  std::size_t begin = last + 1;
  while (begin > 0 && is_name_character(before[begin - 1]))
    --begin;
  const std::string_view name = before.substr(begin, last + 1 - begin);
  return is_one_of(name, {"if", "for", "while", "switch", "catch", "return"})
             ? std::string_view()
             : name;
}

/// "EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0)": a type, and a name with its class.
bool heads_member_definition(std::string_view chunk) {
  const std::string_view name = function_name(chunk);
  return name.find("::") != std::string_view::npos && first_word(chunk) != name &&
         !is_one_of(first_word(chunk), {"return", "else", "throw", "new", "case", "delete"}) &&
         !first_word(chunk).empty();
}

class Finder {
 public:
  explicit Finder(std::string_view text) : code_(code_only(text)) {}

  std::vector<FunctionExtent> find_all() {
    for (at_ = 0; at_ < code_.size(); ++at_)
      step();
    if (open_ > 0) give_back_last_brace();
    return std::move(found_);
  }

 private:
  /// What stands between the last statement and here, without the space in front.
  std::string_view chunk() const {
    const std::size_t begin = code_.find_first_not_of(kSpaces, start_);
    return std::string_view(code_).substr(std::min(begin, at_), at_ - std::min(begin, at_));
  }

  void step() {
    if (code_[at_] == ';') {
      start_ = at_ + 1;
    } else if (code_[at_] == '}') {
      close_namespace();
    } else if (code_[at_] == '{') {
      open_brace();
    }
  }

  void open_brace() {
    const std::string_view head = chunk();
    if (opens_namespace(head)) {
      ++open_;
      start_ = at_ + 1;
    } else if (const std::string_view name = function_name(head); !name.empty()) {
      const auto begin = static_cast<std::size_t>(head.data() - code_.data());
      found_.push_back({std::string(name), begin, at_, 0, true});
      pass_body(found_.back());
      start_ = at_ + 1;
    } else {
      pass_block();
      start_ = at_ + 1;
    }
  }

  /// Leaves `at_` at the brace that closes the block.
  void pass_block() {
    int depth = 0;
    for (; at_ < code_.size(); ++at_) {
      if (code_[at_] == '{') ++depth;
      if (code_[at_] == '}' && --depth == 0) return;
    }
  }

  /// Leaves `at_` at the last character of the function.
  void pass_body(FunctionExtent& function) {
    int depth = 0;
    for (; at_ < code_.size(); ++at_) {
      const char c = code_[at_];
      if (c == '{' && depth > 0 && heads_member_definition(chunk())) {
        at_ -= chunk().size();
        break;
      }
      if (c == '{') ++depth;
      if (c == '}' && --depth == 0) {
        function.end = at_ + 1;
        return;
      }
      if (c == '{' || c == '}' || c == ';') start_ = at_ + 1;
    }
    function.end = at_--;
    function.balanced = false;
  }

  void close_namespace() {
    if (open_ == 0 && !found_.empty()) count_rest_to_function();
    open_ = std::max(0, open_ - 1);
    closing_.push_back({at_, found_.size()});
    start_ = at_ + 1;
  }

  /// There was a brace too many before: the first that closed a namespace.
  void count_rest_to_function() {
    if (closing_.empty() || closing_.front().functions_before == 0) return;
    const Closing& first = closing_.front();
    FunctionExtent& function = found_[first.functions_before - 1];
    function.end = first.at + 1;
    function.balanced = false;
    closing_.clear();
  }

  /// A brace is missing: the last function has taken the one that a namespace needs.
  void give_back_last_brace() {
    if (found_.empty() || !found_.back().balanced) return;
    if (code_.find_first_not_of(kSpaces, found_.back().end) != std::string::npos) return;
    --found_.back().end;
    found_.back().balanced = false;
  }

  struct Closing {
    std::size_t at;
    std::size_t functions_before;
  };

  std::string code_;
  std::vector<FunctionExtent> found_;
  std::vector<Closing> closing_;  ///< braces that close namespaces
  std::size_t at_ = 0;
  std::size_t start_ = 0;  ///< behind the last statement
  int open_ = 0;           ///< namespaces
};

}  // namespace

std::vector<FunctionExtent> find_functions(std::string_view text) {
  return Finder(text).find_all();
}

}  // namespace meshgrade
