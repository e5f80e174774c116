#include "grader/submission/class_members.h"

#include <algorithm>
#include <map>

#include "grader/base/pattern.h"
#include "grader/base/text.h"
#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool begins_with_word(std::string_view text, std::string_view word) {
  return text.substr(0, word.size()) == word &&
         (text.size() == word.size() || !is_word_character(text[word.size()]));
}

/// The last word of a text; empty if it ends with something else.
std::string last_word(std::string_view text) {
  text = trimmed(text);
  std::size_t begin = text.size();
  while (begin > 0 && is_word_character(text[begin - 1]))
    --begin;
  return std::string(text.substr(begin));
}

/// Behind the bracket that closes the one at `open`; the end of the code if none does.
std::size_t behind_brackets(std::string_view code, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < code.size(); ++i) {
    if (code[i] == '(' || code[i] == '{' || code[i] == '[') ++depth;
    if ((code[i] == ')' || code[i] == '}' || code[i] == ']') && --depth == 0) return i + 1;
  }
  return code.size();
}

/// The places of one of these characters that stand outside of all brackets, also < and >.
std::vector<std::size_t> outside_brackets(std::string_view code, std::string_view wanted) {
  std::vector<std::size_t> found;
  int angles = 0;
  for (std::size_t i = 0; i < code.size();) {
    if (angles == 0 && wanted.find(code[i]) != std::string_view::npos) found.push_back(i);
    if (code[i] == '<') ++angles;
    if (code[i] == '>' && angles > 0) --angles;
    const bool opens = code[i] == '(' || code[i] == '{' || code[i] == '[';
    i = opens ? behind_brackets(code, i) : i + 1;
  }
  return found;
}

std::size_t first_or_end(const std::vector<std::size_t>& places, std::string_view code) {
  return places.empty() ? code.size() : places[0];
}

/// Where the name of a declarator ends: before its value, its size or its width.
std::size_t name_end(std::string_view declarator) {
  for (std::size_t at : outside_brackets(declarator, "=[{:")) {
    const bool in_name =
        declarator[at] == ':' &&
        (declarator.substr(at, 2) == "::" || (at > 0 && declarator.substr(at - 1, 2) == "::"));
    if (!in_name) return at;
  }
  return declarator.size();
}

int count_parameters(std::string_view inside) {
  const std::string_view text = trimmed(inside);
  if (text.empty() || text == "void") return 0;
  return 1 + static_cast<int>(outside_brackets(text, ",").size());
}

/// Reads the body of a class, declaration by declaration.
class BodyReader {
 public:
  BodyReader(std::string_view text, std::string_view code, const std::string& class_name)
      : text_(text), code_(code), class_name_(class_name) {}

  void read(std::size_t begin, std::size_t end) {
    start_ = begin;
    for (at_ = begin; at_ < end; ++at_) {
      const char c = code_[at_];
      if (c == ';') {
        take(at_ + 1);
      } else if (c == '{') {
        pass_braces();
      } else if (c == '(' || c == '[') {
        at_ = behind_brackets(code_, at_) - 1;
      } else if (c == ':' && is_label()) {
        start_ = at_ + 1;
      }
    }
  }

  std::vector<ClassMember> members() {
    for (ClassMember& member : members_) {
      if (member.kind == MemberKind::kData) give_values(member);
    }
    return std::move(members_);
  }

 private:
  std::string_view chunk() const { return trimmed(code_.substr(start_, at_ - start_)); }

  bool is_label() const {
    const std::string_view word = chunk();
    return word == "public" || word == "protected" || word == "private";
  }

  bool heads_function() const {
    const std::string_view head = chunk();
    const std::size_t open = first_or_end(outside_brackets(head, "("), head);
    return open < first_or_end(outside_brackets(head, "="), head);
  }

  static bool heads_type(std::string_view head) {
    const char* words[] = {"struct", "class", "enum", "union", "typedef", "using"};
    return std::any_of(std::begin(words), std::end(words),
                       [&](const char* word) { return begins_with_word(head, word); });
  }

  /// A body ends the declaration; the braces of a value or a type do not.
  void pass_braces() {
    const bool body = !heads_type(chunk()) && heads_function();
    const std::size_t end = behind_brackets(code_, at_);
    at_ = end - 1;
    if (body) take(end);
  }

  void take(std::size_t end) {
    const std::size_t first = std::min(code_.find_first_not_of(kBlanks, start_), end);
    start_ = end;
    std::string_view code = code_.substr(first, end - first);
    if (code.size() < 2 || begins_with_word(code, "friend")) return;  // ";" behind a body
    ClassMember member;
    member.class_name = class_name_;
    member.text = text_.substr(first, end - first);
    member.line = line_of(first);
    member.last_line = line_of(end - 1);
    if (heads_type(code)) {
      member.kind = MemberKind::kType;
      member.names = {name_of_type(code)};
    } else if (!name_function(code, member)) {
      return name_data(code, std::move(member));
    }
    if (!member.names[0].empty()) members_.push_back(std::move(member));
  }

  int line_of(std::size_t offset) const {
    return 1 + static_cast<int>(std::count(
                   code_.begin(), code_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
  }

  static std::string name_of_type(std::string_view code) {
    if (begins_with_word(code, "typedef")) return last_word(code.substr(0, code.rfind(';')));
    std::size_t end = code.find_first_of("={;:");
    return last_word(code.substr(0, std::min(end, code.size())));
  }

  /// @return false if the declaration is no function
  bool name_function(std::string_view code, ClassMember& member) {
    const std::size_t open = first_or_end(outside_brackets(code, "("), code);
    const std::size_t value = first_or_end(outside_brackets(code, "={"), code);
    if (open >= code.size() || open > value) return false;
    const std::size_t close = behind_brackets(code, open);
    const std::string name = last_word(code.substr(0, open));
    member.kind = MemberKind::kFunction;
    member.parameters = count_parameters(code.substr(open + 1, close - open - 2));
    const bool is_special = name.empty() || code.find('~') < open || name == "operator" ||
                            code.substr(0, open).find("operator") != std::string_view::npos;
    if (name == class_name_) constructors_ += std::string(code) + "\n";
    member.names = {is_special || name == class_name_ ? "" : name};
    return true;
  }

  void name_data(std::string_view code, ClassMember member) {
    code = code.substr(0, code.rfind(';'));
    if (begins_with_word(code, "static") || begins_with_word(code, "inline")) {
      member.kind = MemberKind::kFunction;
    }
    std::vector<std::size_t> ends = outside_brackets(code, ",");
    ends.push_back(code.size());
    std::size_t begin = 0;
    for (std::size_t end : ends) {
      const std::string_view part = code.substr(begin, end - begin);
      const std::string name = last_word(part.substr(0, name_end(part)));
      if (!name.empty()) member.names.push_back(name);
      begin = end + 1;
    }
    if (!member.names.empty() && member.names[0] != "const") {
      members_.push_back(std::move(member));
    }
  }

  /// What a constructor gives to a member, if it is plain; otherwise nothing.
  std::string value_of(const std::string& name) const {
    const std::string value = "(-?[0-9.]+[fF]?|true|false|Vector3D ?\\([-0-9., ]*\\))";
    constexpr std::size_t kMost = 4000;  // std::regex goes as deep as a text is long
    const std::string code = constructors_.substr(0, kMost);
    for (const std::string& form : {"\\b" + name + "\\s*[({]\\s*" + value + "\\s*[)}]",
                                    "\\b" + name + "\\s*=\\s*" + value + "\\s*;"}) {
      Pattern::Groups found;
      if (Pattern(form).is_in(code, found)) return found[1];
    }
    return {};
  }

  void give_values(ClassMember& member) const {
    std::string code = code_only(member.text);
    std::vector<std::size_t> ends = outside_brackets(code, ",;");
    std::reverse(ends.begin(), ends.end());  // so that offsets before stay right
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const std::size_t begin = i + 1 < ends.size() ? ends[i + 1] + 1 : 0;
      const std::string part = code.substr(begin, ends[i] - begin);
      const std::size_t end = name_end(part);
      if (end < part.size() && part[end] != '[') continue;
      const std::string name = last_word(part.substr(0, end));
      member.text.insert(ends[i], "{" + value_of(name) + "}");
    }
  }

  std::string_view text_;
  std::string_view code_;
  std::string class_name_;
  std::vector<ClassMember> members_;
  std::string constructors_;
  std::size_t at_ = 0;
  std::size_t start_ = 0;
};

/// Where the body of a class begins, behind its brace; npos if it is only declared here.
std::size_t find_body(std::string_view code, const std::string& class_name, std::size_t& from) {
  for (std::size_t at = code.find(class_name, from); at != std::string_view::npos;
       at = code.find(class_name, at + 1)) {
    from = at + class_name.size();
    const bool whole = !is_word_character(code[at - 1]) &&
                       (from >= code.size() || !is_word_character(code[from]));
    const std::string before = last_word(code.substr(0, at));
    if (!whole || (before != "class" && before != "struct")) continue;
    const std::size_t end = code.find_first_of("{;(>,", from);
    if (end != std::string_view::npos && code[end] == '{') return end + 1;
  }
  return std::string_view::npos;
}

}  // namespace

std::vector<ClassMember> find_members(std::string_view header, const std::string& class_name) {
  const std::string text = " " + std::string(header);  // so that there is one before each name
  const std::string code = code_only(text);
  BodyReader reader(text, code, class_name);
  std::size_t from = 0;
  const std::size_t body = find_body(code, class_name, from);
  if (body == std::string_view::npos) return {};
  reader.read(body, behind_brackets(code, body - 1) - 1);
  return reader.members();
}

}  // namespace meshgrade
