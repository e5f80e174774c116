#include "grader/files/data_uri.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>

namespace meshgrade {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// RFC 4648, section 4. Blanks are passed over, and so are missing signs at the end.
std::optional<std::vector<unsigned char>> decode_base64(std::string_view text) {
  std::array<int, 256> value{};
  value.fill(-1);
  for (std::size_t k = 0; k < kDigits.size(); ++k)
    value[static_cast<unsigned char>(kDigits[k])] = static_cast<int>(k);
  std::vector<unsigned char> bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int n_bits = 0;
  for (const char c : text) {
    if (std::isspace(static_cast<unsigned char>(c)) != 0) continue;
    if (c == '=') break;
    const int digit = value[static_cast<unsigned char>(c)];
    if (digit < 0) return std::nullopt;
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    n_bits += 6;
    if (n_bits < 8) continue;
    n_bits -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> static_cast<unsigned>(n_bits)));
  }
  return bytes;
}

}  // namespace

bool is_data_uri(std::string_view uri) {
  return uri.starts_with("data:");
}

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t k = 0; k < text.size(); ++k) {
    unsigned code = 0;
    const std::string_view digits = text.substr(std::min(k + 1, text.size()), 2);
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (text[k] == '%' && digits.size() == 2 && error == std::errc() &&
        end == digits.data() + digits.size()) {
      decoded += static_cast<char>(code);
      k += 2;
    } else {
      decoded += text[k];
    }
  }
  return decoded;
}

std::optional<std::vector<unsigned char>> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (!is_data_uri(uri) || comma == uri.npos) return std::nullopt;
  const std::string_view data = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) return decode_base64(data);
  const std::string decoded = percent_decoded(data);
  return std::vector<unsigned char>(decoded.begin(), decoded.end());
}

}  // namespace meshgrade
