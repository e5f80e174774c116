#include "grader/files/utf8_text.h"

#include <cstdint>

namespace meshgrade {
namespace {

void append_utf8(std::string& text, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6U);
    put(0x80 | (code & 0x3FU));
  } else if (code < 0x10000) {
    put(0xE0 | code >> 12U);
    put(0x80 | (code >> 6U & 0x3FU));
    put(0x80 | (code & 0x3FU));
  } else {
    put(0xF0 | code >> 18U);
    put(0x80 | (code >> 12U & 0x3FU));
    put(0x80 | (code >> 6U & 0x3FU));
    put(0x80 | (code & 0x3FU));
  }
}

std::string from_utf16(std::string_view bytes, bool is_big_endian) {
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(bytes[at]);
    const auto second = static_cast<unsigned char>(bytes[at + 1]);
    return static_cast<std::uint32_t>(is_big_endian ? first << 8U | second
                                                    : second << 8U | first);
  };
  const auto is_half = [](std::uint32_t code, std::uint32_t first) {
    return code >= first && code < first + 0x400;
  };
  std::string text;
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    const std::uint32_t high = unit(at);
    if (is_half(high, 0xD800) && at + 3 < bytes.size() && is_half(unit(at + 2), 0xDC00)) {
      append_utf8(text, 0x10000 + ((high - 0xD800) << 10U) + (unit(at + 2) - 0xDC00));
      at += 2;
    } else {
      append_utf8(text, high >= 0xD800 && high < 0xE000 ? '?' : high);
    }
  }
  return text;
}

}  // namespace

Utf8Text::Utf8Text(std::string_view bytes) : view_(bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) {
    view_.remove_prefix(3);
  } else if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    converted_ = from_utf16(bytes.substr(2), bytes[0] == '\xFE');
    view_ = converted_;
  }
}

}  // namespace meshgrade
