#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace meshgrade {

/// Random numbers that are the same on every machine: the distributions of the standard library
/// are not.
class Random {
 public:
  /// Streams with different names are independent of each other.
  Random(std::uint64_t seed, std::string_view stream) : engine_(mix(seed, stream)) {}

  /// A whole number from 0 to limit - 1.
  std::uint32_t below(std::uint32_t limit) {
    return static_cast<std::uint32_t>(engine_() % limit);
  }

  /// A number from 0 to 1, with 24 random bits: a float holds it exactly.
  double unit() { return static_cast<double>(engine_() >> 40U) / 16777216.0; }

  /// A number from `low` to `high`.
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  /// FNV-1a over the seed and the name, so that the order in which streams are made does not
  /// matter.
  static std::uint64_t mix(std::uint64_t seed, std::string_view stream) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (int i = 0; i < 8; ++i)
      hash = (hash ^ ((seed >> (8 * i)) & 0xFF)) * 1099511628211ULL;
    for (char c : stream)
      hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return hash;
  }

  std::mt19937_64 engine_;
};

}  // namespace meshgrade
