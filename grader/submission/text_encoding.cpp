#include "grader/submission/text_encoding.h"

#include <cstdint>
#include <initializer_list>

namespace meshgrade {
namespace {

constexpr std::uint32_t kByteOrderMark = 0xFEFF;
constexpr std::uint32_t kReplacement = 0xFFFD;

bool begins_with(const std::string& bytes, std::initializer_list<unsigned char> start) {
  std::size_t i = 0;
  for (const unsigned char byte : start) {
    if (i >= bytes.size() || static_cast<unsigned char>(bytes[i]) != byte) return false;
    ++i;
  }
  return true;
}

/// In source code nearly all characters are below 256: one byte of their two is zero.
TextEncoding guess(const std::string& bytes) {
  std::size_t first_zero = 0;
  std::size_t second_zero = 0;
  const std::size_t units = bytes.size() / 2;
  for (std::size_t i = 0; i < units; ++i) {
    first_zero += bytes[2 * i] == '\0' ? 1 : 0;
    second_zero += bytes[2 * i + 1] == '\0' ? 1 : 0;
  }
  // Half of a rare character, such as a smiley, may have a zero on the other side.
  const auto most = [&](std::size_t zeros, std::size_t others) {
    return 2 * zeros > units && 4 * others < zeros;
  };
  if (most(second_zero, first_zero)) return TextEncoding::kUtf16Le;
  if (most(first_zero, second_zero)) return TextEncoding::kUtf16Be;
  return TextEncoding::kBytes;
}

std::uint32_t unit_at(const std::string& bytes, std::size_t i, TextEncoding encoding) {
  const auto first = static_cast<unsigned char>(bytes[i]);
  const auto second = static_cast<unsigned char>(bytes[i + 1]);
  return encoding == TextEncoding::kUtf16Le ? first | static_cast<std::uint32_t>(second) << 8U
                                            : second | static_cast<std::uint32_t>(first) << 8U;
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto tail = [&](unsigned shift) {
    text += static_cast<char>(0x80U | ((code >> shift) & 0x3FU));
  };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0U | (code >> 6U));
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0U | (code >> 12U));
    tail(6);
    tail(0);
  } else {
    text += static_cast<char>(0xF0U | (code >> 18U));
    tail(12);
    tail(6);
    tail(0);
  }
}

bool is_high_half(std::uint32_t unit) {
  return unit >= 0xD800 && unit < 0xDC00;
}

bool is_low_half(std::uint32_t unit) {
  return unit >= 0xDC00 && unit < 0xE000;
}

}  // namespace

TextEncoding encoding_of(const std::string& bytes) {
  if (begins_with(bytes, {0xFF, 0xFE, 0, 0}) || begins_with(bytes, {0, 0, 0xFE, 0xFF})) {
    return TextEncoding::kUtf32;
  }
  if (begins_with(bytes, {0xFF, 0xFE})) return TextEncoding::kUtf16Le;
  if (begins_with(bytes, {0xFE, 0xFF})) return TextEncoding::kUtf16Be;
  return guess(bytes);
}

std::string utf16_to_utf8(const std::string& bytes, TextEncoding encoding) {
  std::string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit_at(bytes, i, encoding);
    if (i == 0 && code == kByteOrderMark) continue;
    if (is_high_half(code) && i + 3 < bytes.size()) {
      const std::uint32_t low = unit_at(bytes, i + 2, encoding);
      if (is_low_half(low)) {
        code = 0x10000 + ((code - 0xD800) << 10U) + (low - 0xDC00);
        i += 2;
      }
    }
    append_utf8(text, is_high_half(code) || is_low_half(code) ? kReplacement : code);
  }
  return text;
}

}  // namespace meshgrade
