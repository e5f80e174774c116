#include "grader/submission/header_definitions.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "grader/base/text.h"
#include "grader/submission/class_members.h"
#include "grader/submission/code_only.h"
#include "grader/submission/course_files.h"
#include "grader/submission/function_extents.h"

namespace meshgrade {
namespace {

/// A definition, in the form that it has outside of its class.
struct Definition {
  std::string name;  ///< "BezierPatch::evaluateStep"
  std::string text;
  int line = 0;
};

/// How many parameters each graded member has, in any year. One of the same name with others
/// is a member that the student has added.
bool has_graded_parameters(const std::string& name, int parameters) {
  if (name == "BezierCurve::evaluateStep") return parameters <= 1;
  if (name == "Vertex::normal") return parameters == 0;
  return parameters == (name.rfind("BezierPatch::", 0) == 0 ? 2 : 1);
}

std::string without_course_prefix(const std::string& name) {
  return name.rfind("CGL::", 0) == 0 ? name.substr(5) : name;
}

/// Where a name stands as a word of its own in code; npos if nowhere.
std::size_t find_name(const std::string& code, const std::string& name) {
  for (std::size_t at = code.find(name); at != std::string::npos;
       at = code.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || !is_word_character(code[at - 1]);
    if (begins && (end == code.size() || !is_word_character(code[end]))) return at;
  }
  return std::string::npos;
}

/// What may stand before a member in its class only, or before a function in a header.
std::string without_specifiers(std::string text) {
  for (const char* word : {"inline", "virtual", "constexpr"}) {
    const std::string code = code_only(text);
    const std::size_t at = find_name(code.substr(0, code.find('(')), word);
    if (at != std::string::npos) text.replace(at, std::string(word).size(), "");
  }
  return text;
}

void add_members(const SourceFile& header, std::vector<Definition>& definitions) {
  for (const std::string& name : graded_functions()) {
    const std::size_t colons = name.find("::");
    const std::string last = name.substr(colons + 2);
    for (const ClassMember& member : find_members(header.text, name.substr(0, colons))) {
      const std::string code = code_only(member.text);
      const std::size_t at = find_name(code, last);
      if (member.kind != MemberKind::kFunction || member.names[0] != last ||
          at == std::string::npos || code.find('{') == std::string::npos ||
          !has_graded_parameters(name, member.parameters)) {
        continue;
      }
      std::string text = member.text;
      text.replace(at, last.size(), name);
      definitions.push_back({name, without_specifiers(std::move(text)), member.line});
    }
  }
}

void add_functions(const SourceFile& header, std::vector<Definition>& definitions) {
  for (const FunctionExtent& function : find_functions(header.text)) {
    const std::string name = without_course_prefix(function.name);
    if (graded_functions().count(name) == 0) continue;
    const std::string before = header.text.substr(0, function.begin);
    definitions.push_back(
        {name,
         without_specifiers(header.text.substr(function.begin, function.end - function.begin)),
         1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'))});
  }
}

/// Each on its own line of the header, as far as the lines before leave it.
std::string source_of(std::vector<Definition> definitions) {
  std::sort(definitions.begin(), definitions.end(),
            [](const Definition& a, const Definition& b) { return a.line < b.line; });
  std::string text = "#include \"student_code.h\"\n";
  int line = 2;
  for (const Definition& definition : definitions) {
    for (; line < definition.line; ++line)
      text += '\n';
    const std::string code = "namespace CGL { using namespace std; " + definition.text + " }\n";
    line += static_cast<int>(std::count(code.begin(), code.end(), '\n'));
    text += code;
  }
  return text;
}

std::set<std::string> functions_of(const std::vector<SourceFile>& files) {
  std::set<std::string> names;
  for (const SourceFile& file : files) {
    for (const FunctionExtent& function : find_functions(file.text))
      names.insert(without_course_prefix(function.name));
  }
  return names;
}

}  // namespace

std::vector<SourceFile> sources_from_headers(const std::vector<SourceFile>& course_headers,
                                             const std::vector<SourceFile>& own) {
  std::set<std::string> known = functions_of(own);
  std::vector<SourceFile> sources;
  for (const SourceFile& header : course_headers) {
    std::vector<Definition> all;
    add_members(header, all);
    add_functions(header, all);
    std::vector<Definition> definitions;
    for (Definition& definition : all) {
      if (known.insert(definition.name).second) definitions.push_back(std::move(definition));
    }
    if (!definitions.empty())
      sources.push_back({header.name + ".cpp", source_of(std::move(definitions))});
  }
  return sources;
}

}  // namespace meshgrade
