#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace meshgrade {

/// A word, number or mark of a C++ text.
struct CodeToken {
  std::uint64_t what = 0;  ///< the same for tokens that count as the same
  std::size_t begin = 0;   ///< in the text, in bytes
  std::size_t end = 0;
};

/// The tokens of a C++ text. Comments, text in quotes and preprocessor lines are none. All
/// names that a student can choose count as the same; keywords, and names behind ".", "->" or
/// "::", which are those of the course's classes, count as what they are.
std::vector<CodeToken> code_tokens(std::string_view text);

}  // namespace meshgrade
