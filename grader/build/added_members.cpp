#include "grader/build/added_members.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <tuple>

#include "grader/base/text.h"
#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostSentences = 20;

/// The words of a text that can be names in C++.
std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names(1);
  for (char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      names.back() += c;
    } else if (!names.back().empty()) {
      names.emplace_back();
    }
  }
  if (names.back().empty()) names.pop_back();
  return names;
}

bool is_course_class(const std::string& name) {
  static const std::set<std::string> classes{
      "Halfedge", "Vertex", "Edge", "Face", "HalfedgeMesh", "BezierCurve", "BezierPatch"};
  return classes.count(name) != 0;
}

/// What stands behind `mark` in the text; empty if it is not there.
std::string behind(const std::string& text, const std::string& mark) {
  const std::size_t found = text.find(mark);
  return found == std::string::npos ? "" : text.substr(found + mark.size());
}

struct Member {
  std::string class_name;
  std::string name;

  bool operator<(const Member& other) const {
    return std::tie(class_name, name) < std::tie(other.class_name, other.name);
  }
};

/// The class that is named last in front of `end`.
std::string class_before(const std::vector<std::string>& names,
                         std::vector<std::string>::const_iterator end) {
  std::string found;
  for (auto name = names.begin(); name != end; ++name) {
    if (is_course_class(*name)) found = *name;
  }
  return found;
}

/// GCC: ‘class meshedit::Vertex’ has no member named ‘x’; Clang: no member named 'x' in
/// 'meshedit::Vertex'.
Member used_member(const std::string& message) {
  const std::vector<std::string> after = names_in(behind(message, "no member named "));
  if (after.empty()) return {};
  const std::vector<std::string> all = names_in(message.substr(0, message.find(';')));
  return {class_before(all, all.end()), after[0]};
}

/// GCC: no declaration matches ‘bool meshedit::HalfedgeMesh::f(int)’; Clang: out-of-line
/// definition of 'f' does not match any declaration in 'meshedit::HalfedgeMesh'.
Member defined_member(const std::string& message) {
  const std::vector<std::string> after = names_in(behind(message, "no declaration matches "));
  for (std::size_t i = 0; i + 1 < after.size(); ++i) {
    if (i > 0 && after[i - 1] == "meshedit" && is_course_class(after[i])) {
      const std::string both = after[i] + "::" + after[i + 1];
      if (message.find(both) != std::string::npos) return {after[i], after[i + 1]};
    }
  }
  const std::vector<std::string> clang =
      names_in(behind(message, "out-of-line definition of "));
  return clang.empty() ? Member{} : Member{class_before(clang, clang.end()), clang[0]};
}

/// "halfEdgeMesh.h, line 88", or empty.
std::string place_in(const std::vector<SourceFile>& headers, const std::string& member) {
  for (const SourceFile& header : headers) {
    const std::vector<std::string> lines = split_lines(code_only(header.text));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::vector<std::string> names = names_in(lines[i]);
      if (std::find(names.begin(), names.end(), member) != names.end()) {
        return header.name + ", line " + std::to_string(i + 1);
      }
    }
  }
  return {};
}

std::string explain(const std::string& use, const Member& member, const std::string& place) {
  const std::string name = member.class_name + "::" + member.name;
  if (!place.empty()) {
    return use + " uses " + name + ", a member that was added to the course's header (" +
           place +
           "): the grader has its own mesh and Bezier classes, so such members cannot be "
           "graded";
  }
  return use + " uses " + name + ", which is no member of the course's " + member.class_name +
         "; if it was added to the course's header: the grader has its own mesh and Bezier "
         "classes, so such members cannot be graded";
}

}  // namespace

std::vector<std::string> explain_added_members(const std::string& messages,
                                               const std::vector<SourceFile>& headers) {
  std::vector<std::string> sentences;
  std::set<Member> told;
  for (const std::string& line : split_lines(messages)) {
    if (sentences.size() == kMostSentences) break;
    const std::string message = behind(line, ": error: ");
    Member member = used_member(message);
    if (member.class_name.empty()) member = defined_member(message);
    if (member.class_name.empty() || !told.insert(member).second) continue;
    const std::size_t column = line.find(':', line.find(':') + 1);  // file:line:column: error
    sentences.push_back(
        explain(line.substr(0, column), member, place_in(headers, member.name)));
  }
  return sentences;
}

}  // namespace meshgrade
