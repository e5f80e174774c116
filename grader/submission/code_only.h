#pragma once

#include <string>
#include <string_view>

namespace meshgrade {

/// A C++ source with everything blanked that is no code: comments, what stands between quotes
/// (raw strings, too), and preprocessor lines. Line ends stay, so that every character that is
/// left stands where it stood; the result has the size of the text.
std::string code_only(std::string_view text);

}  // namespace meshgrade
