#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshgrade {

bool is_data_uri(std::string_view uri);

/// The bytes of "data:[type][;parameters][;base64],..." (RFC 2397). Nothing if it is broken.
std::optional<std::vector<unsigned char>> decode_data_uri(std::string_view uri);

/// With "%20" and the like replaced by what they stand for.
std::string percent_decoded(std::string_view text);

}  // namespace meshgrade
