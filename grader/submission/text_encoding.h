#pragma once

#include <string>

namespace meshgrade {

/// How the characters of a text file are written as bytes, as far as it matters here.
enum class TextEncoding {
  kBytes,    ///< UTF-8, or anything else that compilers read as it is
  kUtf16Le,  ///< as Visual Studio and Windows' Notepad can save it
  kUtf16Be,
  kUtf32,
};

/// By the byte order mark; without one, by where the zero bytes of plain letters stand.
TextEncoding encoding_of(const std::string& bytes);

/// UTF-8 for a text in kUtf16Le or kUtf16Be, without the byte order mark. Lines and columns
/// stay as they are. What is no character becomes U+FFFD.
std::string utf16_to_utf8(const std::string& bytes, TextEncoding encoding);

}  // namespace meshgrade
