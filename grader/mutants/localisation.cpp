#include "grader/mutants/localisation.h"

#include <algorithm>
#include <map>

#include "grader/base/pattern.h"

namespace meshgrade {
namespace {

/// A name that does not depend on the direction of an edge or the first corner of a face.
PointerName pointer_name(char kind, std::string role, const std::string& member) {
  switch (kind) {
    case 'h':
      return "half-edge " + role + "." + member;
    case 'v':
      return "vertex " + role + "." + member;
    case 'e':
      std::sort(role.begin(), role.end());
      return "edge " + role + "." + member;
    default:
      if (!role.empty()) {
        std::rotate(role.begin(), std::min_element(role.begin(), role.end()), role.end());
      }
      return "face " + role + "." + member;
  }
}

/// The textbook's variables: `a`, `ab`, `edge_ab`, `face_abd`.
PointerName pointer_of_variable(const std::string& variable, const std::string& member) {
  if (variable.rfind("edge_", 0) == 0) return pointer_name('e', variable.substr(5), member);
  if (variable.rfind("face_", 0) == 0) return pointer_name('f', variable.substr(5), member);
  return pointer_name(variable.size() == 1 ? 'v' : 'h', variable, member);
}

/// The pointers that a line sets, with the values; nothing for a line that does anything else.
std::map<PointerName, std::string> assignments(const std::string& line) {
  static const Pattern all(
      R"((\w+)->setNeighbors\(([^,]+), ([^,]+), ([^,]+), ([^,]+), ([^,]+)\);)");
  static const Pattern one(R"((\w+)->(next|twin|vertex|edge|face|halfedge)\(\) = ([^;]+);)");
  static const char* const members[] = {"next", "twin", "vertex", "edge", "face"};
  std::map<PointerName, std::string> set;
  Pattern::Groups match;
  if (all.matches(line, match)) {
    for (std::size_t i = 0; i < 5; ++i)
      set[pointer_of_variable(match[1], members[i])] = match[i + 2];
  } else if (one.matches(line, match)) {
    set[pointer_of_variable(match[1], match[2])] = match[3];
  }
  return set;
}

}  // namespace

std::set<PointerName> wrong_pointers(const Mutant& mutant) {
  const bool has_roles = mutant.original == "textbook" &&
                         (mutant.exercise == "edge_flip" || mutant.exercise == "edge_split");
  const auto before = assignments(mutant.was);
  const auto after = assignments(mutant.becomes);
  if (!has_roles || before.empty() || (after.empty() && mutant.becomes != ";")) return {};
  std::set<PointerName> wrong;
  for (const auto* from : {&before, &after}) {
    const auto& other = from == &before ? after : before;
    for (const auto& [pointer, value] : *from) {
      const auto found = other.find(pointer);
      if (found == other.end() || found->second != value) wrong.insert(pointer);
    }
  }
  return wrong;
}

PointerName named_pointer(const std::string& element) {
  static const Pattern form(R"(([hvef])\d+\.(\w+), of (\w+))");
  Pattern::Groups match;
  if (!form.matches(element, match)) return {};
  return pointer_name(match[1][0], match[3], match[2]);
}

}  // namespace meshgrade
