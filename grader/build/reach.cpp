#include "grader/build/reach.h"

#include <algorithm>
#include <set>

#include "grader/build/file_scope.h"
#include "grader/submission/function_extents.h"

namespace meshgrade {
namespace {

using Names = std::set<std::string>;

/// Functions of the C library that compilers call where the source does not name them.
const Names& called_by_compilers() {
  static const Names names{"memcpy", "memmove", "memset", "memcmp", "strlen", "abort"};
  return names;
}

const Names& assembly() {
  static const Names words{"asm", "__asm", "__asm__"};
  return words;
}

bool have_common(const Names& a, const Names& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](const std::string& name) { return b.count(name) != 0; });
}

std::string last_name(const std::string& function) {
  const std::size_t colon = function.rfind(':');
  return colon == std::string::npos ? function : function.substr(colon + 1);
}

/// What a file gives names to, and what it mentions.
struct Reach {
  Names gives;
  Names mentions;
  bool is_everywhere = false;
  bool may_reach_all = false;  ///< it may mention what is not in its words
};

Reach reach_of(const SourceFile& source) {
  FileScope scope = read_file_scope(source.text);
  Reach reach{std::move(scope.declares), std::move(scope.words)};
  for (const FunctionExtent& function : find_functions(source.text))
    reach.gives.insert(last_name(function.name));
  reach.is_everywhere = !scope.is_plain || scope.acts_at_start ||
                        have_common(reach.gives, called_by_compilers()) ||
                        have_common(reach.mentions, assembly());
  reach.may_reach_all = !scope.has_all_words || have_common(reach.mentions, assembly());
  return reach;
}

}  // namespace

std::vector<std::size_t> files_reached(const std::vector<SourceFile>& sources,
                                       const std::vector<std::string>& functions) {
  Names wanted;
  for (const std::string& function : functions)
    wanted.insert(last_name(function));
  std::vector<Reach> reaches;
  std::vector<std::size_t> waiting;
  std::vector<bool> reached(sources.size());
  const auto take = [&](std::size_t i) {
    if (!reached[i]) waiting.push_back(i);
    reached[i] = true;
  };
  for (std::size_t i = 0; i < sources.size(); ++i) {
    reaches.push_back(reach_of(sources[i]));
    if (reaches[i].is_everywhere || have_common(wanted, reaches[i].mentions)) take(i);
  }
  while (!waiting.empty()) {
    const Reach& here = reaches[waiting.back()];
    waiting.pop_back();
    for (std::size_t i = 0; i < sources.size(); ++i) {
      // Either way: two definitions of one name shut each other out when they are linked.
      if (have_common(reaches[i].gives, here.mentions) ||
          have_common(here.gives, reaches[i].gives)) {
        take(i);
      }
    }
  }
  const bool is_all = std::any_of(reaches.begin(), reaches.end(),
                                  [](const Reach& reach) { return reach.may_reach_all; });
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (is_all || reached[i]) places.push_back(i);
  }
  return places;
}

}  // namespace meshgrade
