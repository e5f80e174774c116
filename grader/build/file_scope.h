#pragma once

#include <set>
#include <string>
#include <string_view>

namespace meshgrade {

/// What a C++ source shows to one that would be compiled behind it as part of the same text,
/// and what it could see of one before it. Told from its words alone.
struct FileScope {
  /// False if it may show more than is named here: macros, operators, specializations of
  /// templates, names that are looked up by their arguments, or anything that is not
  /// understood.
  bool is_plain = false;
  std::set<std::string> includes;  ///< "<cmath>", "\"meshedit/meshedit.h\""
  std::set<std::string> usings;    ///< "using namespace std"
  std::set<std::string> declares;  ///< names of functions, variables, types and namespaces
  std::set<std::string> words;     ///< the names that it mentions, in macros as well
  /// False if it may mention others: pieces that a macro puts together, "##", or unusual
  /// spellings.
  bool has_all_words = false;
  /// Whether anything of it could run before one of its functions is called: it may hold
  /// variables other than constants, or what looks like one.
  bool acts_at_start = false;
};

FileScope read_file_scope(std::string_view text);

}  // namespace meshgrade
