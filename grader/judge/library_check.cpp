#include "grader/judge/library_check.h"

#include <algorithm>
#include <map>
#include <string>

#include "grader/judge/findings.h"

namespace meshgrade {
namespace {

/// "std::vector", "operator[]"
struct LibraryCall {
  std::string type;
  std::string member;
};

std::string without(std::string text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part)) {
    text.erase(at, part.size());
  }
  return text;
}

std::string without_template_arguments(const std::string& text) {
  std::string rest;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool arrow = text[i] == '>' && i > 0 && text[i - 1] == '-';
    if (text[i] == '<') ++depth;
    if (depth == 0) rest += text[i];
    if (text[i] == '>' && !arrow && depth > 0) --depth;
  }
  return rest;
}

/// Which class is meant by what it is made of.
std::string public_name(const std::string& type) {
  static const std::map<std::string, std::string> names{{"basic_string", "string"},
                                                        {"basic_string_view", "string_view"},
                                                        {"_Optional_base_impl", "optional"},
                                                        {"_Optional_base", "optional"},
                                                        {"__shared_ptr_access", "shared_ptr"}};
  const auto found = names.find(type);
  return "std::" + (found == names.end() ? type : found->second);
}

/// Out of a whole declaration, as libstdc++ passes it, or a demangled name: "int&
/// std::vector<_Tp, _Alloc>::operator[](size_type) [with ...]".
LibraryCall find_call(const std::string& text) {
  std::string name = text.substr(0, text.find(" [with"));
  name = name.substr(0, name.find("[abi:"));
  name = without_template_arguments(name);
  name = name.substr(0, name.find('('));
  name = name.substr(name.rfind(' ') + 1);
  name = without(without(name, "__cxx11::"), "__1::");
  const std::size_t colon = name.rfind("::");
  if (name.rfind("std::", 0) != 0) return {};
  if (colon <= 3) return {"", name};  // a function of no class
  return {public_name(name.substr(5, colon - 5)), name.substr(colon + 2)};
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool needs_elements(const std::string& member) {
  for (const char* name : {"front", "back", "pop_back", "pop_front", "top", "pop"}) {
    if (member == name) return true;
  }
  return false;
}

std::string or_else(const std::string& text, const std::string& otherwise) {
  return text.empty() ? otherwise : text;
}

Finding about_index(const LibraryCall& call) {
  const std::string type = or_else(call.type, "container of the standard library");
  return make_finding("index-out-of-range", "an index is at least 0 and less than size()", "",
                      "", "",
                      "an index of a " + type + " is out of range: there is no such element",
                      "print the index and size() before this line. i + 1 in a loop up to the "
                      "end? An index that begins with 1, or with -1?");
}

Finding about_nothing(const LibraryCall& call) {
  const std::string type = or_else(call.type, "container of the standard library");
  const std::string member = call.member.empty() ? "" : call.member + "() of ";
  return make_finding("empty-container", "what is taken out of a container is in it", "", "",
                      "", member + "a " + type + " that is empty: there is nothing to take",
                      "what is to fill it before this line, and does so always?");
}

Finding about_missing_value(const LibraryCall& call) {
  return make_finding(
      "empty-container", "what is taken out of a container is in it", "", "", "",
      "a " + call.type + " was used that holds nothing",
      "what is to set it before this line, and does so always? Ask it with `if` before use");
}

Finding about_anything(const std::string& subject) {
  return make_finding("library-check",
                      "functions of the standard library get what they ask for", "", "", "",
                      "the standard library refused a call: " + subject,
                      "what does the documentation of this function ask of its arguments?");
}

Finding explain_failed_check(const std::string& subject) {
  const std::size_t in = subject.find("in ");
  const std::string condition = subject.substr(0, in);
  const LibraryCall call = find_call(in == std::string::npos ? "" : subject.substr(in + 3));
  const bool holds_one = call.type == "std::optional" || call.type == "std::unique_ptr" ||
                         call.type == "std::shared_ptr";
  if (holds_one) return about_missing_value(call);
  if (needs_elements(call.member) || holds(subject, "empty")) return about_nothing(call);
  if (holds(call.member, "operator[]") || holds(condition, "< this->size()") ||
      holds(subject, "out of bounds")) {
    return about_index(call);
  }
  return about_anything(subject);
}

}  // namespace

Finding library_check_finding(const Outcome& outcome) {
  Finding finding = explain_failed_check(outcome.subject);
  finding.stack = outcome.stack;
  return finding;
}

}  // namespace meshgrade
