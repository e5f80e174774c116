#include "grader/base/digest.h"

#include <openssl/evp.h>

#include <array>

#include "grader/base/errors.h"

namespace meshgrade {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> hash{};
  unsigned size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), hash.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw GraderError("SHA-256 cannot be computed");
  }
  std::string text;
  for (unsigned i = 0; i < size; ++i) {
    constexpr char kDigits[] = "0123456789abcdef";
    text += kDigits[hash[i] >> 4U];
    text += kDigits[hash[i] & 15U];
  }
  return text;
}

Digest& Digest::add(std::string_view text) {
  state_ += sha256(text);
  return *this;
}

std::string Digest::hex() const {
  return sha256(state_);
}

}  // namespace meshgrade
