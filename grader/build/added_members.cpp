#include "grader/build/added_members.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "grader/base/text.h"
#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostMembers = 20;

/// The words of a text that can be names in C++.
std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names(1);
  for (char c : text) {
    if (is_word_character(c)) {
      names.back() += c;
    } else if (!names.back().empty()) {
      names.emplace_back();
    }
  }
  if (names.back().empty()) names.pop_back();
  return names;
}

/// What the course calls this class; empty if it is none of the course's.
std::string course_class(const std::string& name) {
  static const std::set<std::string> classes{"Halfedge",    "Vertex",      "Edge",
                                             "EdgeRecord",  "Face",        "HalfedgeMesh",
                                             "BezierCurve", "BezierPatch", "Halfedge_Mesh"};
  const std::size_t year = name.rfind("2017");  // see include/dropin/course_2017.h
  const std::string plain =
      year != std::string::npos && year + 4 == name.size() ? name.substr(0, year) : name;
  return classes.count(plain) != 0 ? plain : "";
}

/// What stands behind `mark` in the text; empty if it is not there.
std::string behind(const std::string& text, const std::string& mark) {
  const std::size_t found = text.find(mark);
  return found == std::string::npos ? "" : text.substr(found + mark.size());
}

/// The class that is named last in front of `end`.
std::string class_before(const std::vector<std::string>& names,
                         std::vector<std::string>::const_iterator end) {
  std::string found;
  for (auto name = names.begin(); name != end; ++name) {
    if (const std::string known = course_class(*name); !known.empty()) found = known;
  }
  return found;
}

/// GCC: ‘class meshedit::Vertex’ has no member named ‘x’; Clang: no member named 'x' in
/// 'meshedit::Vertex'.
MemberUse used_member(const std::string& message) {
  const std::vector<std::string> after = names_in(behind(message, "no member named "));
  if (after.empty()) return {};
  const std::vector<std::string> all = names_in(message.substr(0, message.find(';')));
  return {class_before(all, all.end()), after[0], ""};
}

/// GCC: no declaration matches ‘bool meshedit::HalfedgeMesh::f(int)’; Clang: out-of-line
/// definition of 'f' does not match any declaration in 'meshedit::HalfedgeMesh'.
MemberUse defined_member(const std::string& message) {
  const std::vector<std::string> after = names_in(behind(message, "no declaration matches "));
  for (std::size_t i = 0; i + 1 < after.size(); ++i) {
    const std::string known = course_class(after[i]);
    if (i == 0 || after[i - 1] != "meshedit" || known.empty()) continue;
    const std::string both = after[i] + "::" + after[i + 1];
    if (message.find(both) != std::string::npos) return {known, after[i + 1], ""};
  }
  const std::vector<std::string> clang =
      names_in(behind(message, "out-of-line definition of "));
  return clang.empty() ? MemberUse{}
                       : MemberUse{class_before(clang, clang.end()), clang[0], ""};
}

}  // namespace

MemberUse unknown_member(const std::string& complaint) {
  MemberUse member = used_member(complaint);
  return member.empty() ? defined_member(complaint) : member;
}

std::vector<MemberUse> unknown_members(const std::string& messages) {
  std::vector<MemberUse> members;
  std::set<std::pair<std::string, std::string>> told;
  for (const std::string& line : split_lines(messages)) {
    if (members.size() == kMostMembers) break;
    MemberUse member = unknown_member(behind(line, ": error: "));
    if (member.empty() || !told.insert({member.class_name, member.name}).second) continue;
    const std::size_t column = line.find(':', line.find(':') + 1);  // file:line:column: error
    member.place = line.substr(0, column);
    members.push_back(member);
  }
  return members;
}

std::string complaint_about(const std::string& messages, const std::string& file, int line,
                            int last_line) {
  for (const std::string& said : split_lines(messages)) {
    const std::string place = file + ":";
    const std::size_t at = said.find(": error: ");
    if (file.empty() || at == std::string::npos || said.rfind(place, 0) != 0) continue;
    const int number = std::atoi(said.c_str() + place.size());
    if (line <= number && number <= last_line) return behind(said, ": error: ");
  }
  return {};
}

std::string place_of_member(const std::vector<SourceFile>& headers, const std::string& name) {
  for (const SourceFile& header : headers) {
    const std::vector<std::string> lines = split_lines(code_only(header.text));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::vector<std::string> names = names_in(lines[i]);
      if (std::find(names.begin(), names.end(), name) != names.end()) {
        return header.name + ", line " + std::to_string(i + 1);
      }
    }
  }
  return {};
}

}  // namespace meshgrade
