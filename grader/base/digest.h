#pragma once

#include <string>
#include <string_view>

namespace meshgrade {

/// SHA-256 of several texts, one after the other. Their bounds count: "a", "bc" is not "ab",
/// "c".
class Digest {
 public:
  Digest& add(std::string_view text);
  /// 64 hexadecimal digits.
  std::string hex() const;

 private:
  std::string state_;  ///< SHA-256 of each text
};

/// SHA-256 of the bytes: 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace meshgrade
