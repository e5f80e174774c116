#include "grader/build/file_scope.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "grader/base/text.h"
#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

using WordList = std::vector<std::string>;

bool is_name(const std::string& word) {
  return is_word_character(word[0]) && std::isdigit(static_cast<unsigned char>(word[0])) == 0;
}

bool is_among(const std::string& word, const std::set<std::string>& words) {
  return words.count(word) != 0;
}

/// Never the name of anything, and mentioned everywhere.
const std::set<std::string>& keywords() {
  static const std::set<std::string> words{
      "auto",   "bool",     "char",   "class",  "const",  "constexpr", "decltype", "double",
      "enum",   "float",    "for",    "if",     "inline", "int",       "long",     "namespace",
      "return", "short",    "signed", "static", "struct", "template",  "typedef",  "typename",
      "union",  "unsigned", "using",  "void",   "while"};
  return words;
}

/// Stand before a type.
const std::set<std::string>& specifiers() {
  static const std::set<std::string> words{"const",    "constexpr", "inline",       "static",
                                           "typedef",  "volatile",  "thread_local", "constinit",
                                           "register", "mutable",   "typename"};
  return words;
}

/// Words outside of function bodies after which more is visible than the names that are read
/// here; and names that templates of the library look up where their arguments come from.
const std::set<std::string>& far_reaching() {
  static const std::set<std::string> words{
      "operator",  "extern",    "asm",    "__asm__", "__attribute__", "alignas",
      "friend",    "concept",   "export", "import",  "module",        "swap",
      "iter_swap", "iter_move", "begin",  "end",     "size",          "data",
      "empty",     "get",       "hash",   "std",     "_Pragma"};
  return words;
}

/// Words by which a text could tell that it is compiled as a part of another.
const std::set<std::string>& aware_of_file() {
  static const std::set<std::string> words{"__COUNTER__", "__BASE_FILE__", "__INCLUDE_LEVEL__",
                                           "__FILE__",    "_Pragma",       "__has_include"};
  return words;
}

/// Names, numbers and single other characters; "::" is one.
WordList split_code(std::string_view code) {
  WordList words;
  for (std::size_t i = 0; i < code.size();) {
    std::size_t end = i + 1;
    if (is_word_character(code[i])) {
      while (end < code.size() && is_word_character(code[end]))
        ++end;
    } else if (code.substr(i, 2) == "::") {
      ++end;
    } else if (std::isspace(static_cast<unsigned char>(code[i])) != 0) {
      i = end;
      continue;
    }
    words.emplace_back(code.substr(i, end - i));
    i = end;
  }
  return words;
}

/// Reads what stands between functions.
class Reader {
 public:
  Reader(WordList words, FileScope& scope) : words_(std::move(words)), scope_(scope) {}

  /// @return whether everything was understood
  bool read() {
    while (at_ < words_.size() && understood_)
      read_declaration();
    return understood_ && open_ == 0;
  }

 private:
  const std::string& word(std::size_t i) const {
    static const std::string none = ";";
    return i < words_.size() ? words_[i] : none;
  }

  void read_declaration() {
    const std::string& first = word(at_);
    if (first == "}") {
      understood_ = --open_ >= 0;
      ++at_;
    } else if (first == ";") {
      ++at_;
    } else if (first == "namespace" || (first == "inline" && word(at_ + 1) == "namespace")) {
      read_namespace();
    } else if (first == "using" && word(at_ + 2) != "=") {
      read_using();
    } else {
      read_names();
    }
  }

  void read_namespace() {
    for (; at_ < words_.size() && word(at_) != "{" && word(at_) != ";"; ++at_) {
      const std::string& name = word(at_);
      if (is_among(name, far_reaching()) && word(at_ - 1) != "=") understood_ = false;
      if (is_name(name) && !is_among(name, {"namespace", "inline", "meshedit", "CGL"}))
        scope_.declares.insert(name);
    }
    if (word(at_++) == "{") ++open_;
  }

  void read_using() {
    std::string text;
    for (; at_ < words_.size() && word(at_) != ";"; ++at_)
      text += word(at_) + " ";
    scope_.usings.insert(text);
  }

  /// Leaves `at_` behind the bracket that closes the one here.
  void pass_brackets() {
    int depth = 0;
    for (; at_ < words_.size(); ++at_) {
      const std::string& mark = word(at_);
      if (is_among(mark, {"(", "{", "["})) ++depth;
      if (is_among(mark, {")", "}", "]"}) && --depth == 0) {
        ++at_;
        return;
      }
    }
    understood_ = false;
  }

  /// A function, variables, or a type, up to its end. All that could be a name which it gives
  /// is taken for one: names that brackets, a value, a comma or the end follow.
  void read_names() {
    bool is_function = false;
    bool has_enum = false;
    bool has_value = false;
    const std::size_t begin = at_;
    while (at_ < words_.size() && understood_) {
      const std::string& here = word(at_);
      if (here == ";") {
        note_variables(begin);
        return;
      }
      if (here == "}") {
        understood_ = false;
      } else if (here == "(" || here == "[") {
        if (here == "(" && !is_function && !has_value) require_plain_name(begin);
        if (here == "[" && !has_value) require_array(begin);
        is_function = is_function || here == "(";
        pass_brackets();
      } else if (here == "{") {
        if (has_enum) read_enumerators();
        pass_block();
        if (is_function || word(at_) != ";") return;
      } else {
        has_enum = has_enum || here == "enum";
        has_value = has_value || here == "=";
        read_word(begin);
        ++at_;
      }
    }
  }

  /// What ends with a semicolon and no body may be a variable, but for constants, types without
  /// anything static, and other names for types.
  void note_variables(std::size_t begin) {
    const WordList declaration(words_.begin() + static_cast<std::ptrdiff_t>(begin),
                               words_.begin() + static_cast<std::ptrdiff_t>(at_));
    const auto mentions = [&](const char* text) {
      return std::find(declaration.begin(), declaration.end(), text) != declaration.end();
    };
    const bool ends_block = !declaration.empty() && declaration.back() == "}";
    const bool is_type =
        is_among(word(begin), {"struct", "class", "union", "enum"}) && ends_block;
    const bool is_quiet = is_among(word(begin), {"using", "typedef", "constexpr"}) ||
                          (is_type && !mentions("static"));
    if (!is_quiet) scope_.acts_at_start = true;
  }

  /// The first parentheses must stand behind a type and a name: `double (*f)(int)`, `Foo (x)`
  /// give a name that stands in them.
  void require_plain_name(std::size_t begin) {
    const bool has_both = at_ >= begin + 2 && is_name(word(at_ - 1));
    const std::string& before = has_both ? word(at_ - 2) : word(at_);
    const bool ends_type = is_among(before, {">", "*", "&", "::", "~"}) ||
                           (is_name(before) && !is_among(before, specifiers()));
    if (!ends_type || is_among(word(at_ - 1), keywords())) understood_ = false;
  }

  /// Other brackets than those of an array give names, `auto [a, b]`, or are attributes.
  void require_array(std::size_t begin) {
    const bool follows = at_ > begin && (word(at_ - 1) == "]" || is_name(word(at_ - 1)));
    if (!follows || is_among(word(at_ - 1), keywords())) understood_ = false;
  }

  void read_word(std::size_t begin) {
    const std::string& here = word(at_);
    const bool qualified = at_ > begin && word(at_ - 1) == "::";
    if (is_among(here, far_reaching()) && !is_std_name()) understood_ = false;
    if (here == "template" && (word(at_ + 1) != "<" || word(at_ + 2) == ">"))
      understood_ = false;
    if (!is_name(here) || qualified || is_among(here, keywords())) return;
    const bool names_type = at_ > begin && is_among(word(at_ - 1), {"class", "struct", "union",
                                                                    "enum", "typename"});
    if (names_type || is_among(word(at_ + 1), {"(", "[", "{", "=", ",", ";", ":"}))
      scope_.declares.insert(here);
  }

  /// "std" in "std::vector<int>", and a name of the library behind it.
  bool is_std_name() const {
    return (word(at_) == "std" && word(at_ + 1) == "::") ||
           (at_ >= 2 && word(at_ - 1) == "::" && word(at_ - 2) == "std");
  }

  void read_enumerators() {
    for (std::size_t i = at_; i < words_.size() && word(i) != "}"; ++i) {
      if (is_name(word(i))) scope_.declares.insert(word(i));
    }
  }

  /// A body, or what is in a type: none of it is seen outside, but for friends of a type.
  void pass_block() {
    const std::size_t open = at_;
    pass_brackets();
    for (std::size_t i = open; i < at_; ++i)
      understood_ = understood_ && word(i) != "friend";
  }

  WordList words_;
  FileScope& scope_;
  std::size_t at_ = 0;
  int open_ = 0;  ///< namespaces
  bool understood_ = true;
};

/// The text with another letter where a directive could begin, so that it counts as code.
std::string with_directives(std::string_view text) {
  std::string all(text);
  std::replace(all.begin(), all.end(), '#', '$');
  return all;
}

/// Takes the includes out of the code.
/// @return whether there are no other directives
bool read_includes(std::string_view text, std::string& code, FileScope& scope) {
  for (std::size_t at = code.find('$'); at != std::string::npos; at = code.find('$', at)) {
    const std::size_t begin = code.rfind('\n', at) + 1;  // 0 behind npos
    const std::size_t end = std::min(code.find('\n', at), code.size());
    if (text[at] != '#' || code.find_first_not_of(" \t", begin) != at) return false;
    const WordList words = split_code(std::string_view(code).substr(at + 1, end - at - 1));
    if (words.empty() || words[0] != "include") return false;
    const std::string rest(text.substr(at, end - at));
    const std::size_t open = rest.find_first_of("<\"");
    const std::size_t close =
        open == std::string::npos ? open : rest.find(rest[open] == '<' ? '>' : '"', open + 1);
    if (close == std::string::npos) return false;
    if (rest.find("/*") != std::string::npos || rest.find("//", open) < close) return false;
    scope.includes.insert(rest.substr(open, close + 1 - open));
    std::fill(code.begin() + static_cast<std::ptrdiff_t>(at),
              code.begin() + static_cast<std::ptrdiff_t>(end), ' ');
  }
  return true;
}

/// Lines that go on, other spellings of characters, letters beyond ASCII.
bool is_plainly_spelled(const std::string& code) {
  const bool ascii = std::all_of(code.begin(), code.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 128; });
  const std::vector<std::string> marks{"\\", "%:", "<%", "%>", "<:", ":>", "??"};
  return ascii && std::none_of(marks.begin(), marks.end(), [&](const std::string& mark) {
           return code.find(mark) != std::string::npos;
         });
}

}  // namespace

FileScope read_file_scope(std::string_view text) {
  FileScope scope;
  std::string code = code_only(with_directives(text));
  const bool has_only_includes = read_includes(text, code, scope);
  const bool is_plain = is_plainly_spelled(code);
  WordList words = split_code(code);
  for (const std::string& word : words) {
    if (is_name(word)) scope.words.insert(word);
  }
  scope.has_all_words = is_plain && code.find("$$") == std::string::npos;
  if (!has_only_includes || !is_plain) return scope;
  const std::set<std::string>& aware = aware_of_file();
  const bool is_aware = std::any_of(aware.begin(), aware.end(), [&](const std::string& word) {
    return is_among(word, scope.words);
  });
  scope.is_plain = Reader(std::move(words), scope).read() && !is_aware;
  return scope;
}

}  // namespace meshgrade
