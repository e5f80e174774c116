#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "grader/files/checked_input.h"
#include "grader/files/file_bytes.h"
#include "grader/files/text_scanner.h"

namespace meshgrade {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;
using Corner = std::array<float, 3>;

/// OpenMesh's own measure of "the same point".
bool same_point(const Corner& a, const Corner& b) {
  constexpr float kSmallest = std::numeric_limits<float>::min();
  return std::abs(a[0] - b[0]) <= kSmallest && std::abs(a[1] - b[1]) <= kSmallest &&
         std::abs(a[2] - b[2]) <= kSmallest;
}

/// OpenMesh would drop such a facet without a word.
void check_facet(const std::filesystem::path& file, const std::string& place, std::size_t face,
                 const std::array<Corner, 3>& corners) {
  const std::string name = "face f" + std::to_string(face);
  for (const Corner& corner : corners) {
    for (const float coordinate : corner) {
      if (!std::isfinite(coordinate)) {
        refuse_file(file, place, name + " has a coordinate that is not a finite number");
      }
    }
  }
  if (same_point(corners[0], corners[1]) || same_point(corners[1], corners[2]) ||
      same_point(corners[2], corners[0])) {
    refuse_file(file, place,
                name + " has two corners at the same point; remove it or spread them");
  }
}

bool has_binary_size(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes) return false;
  std::uint32_t n_faces = 0;
  std::memcpy(&n_faces, bytes.data() + kHeaderBytes - sizeof(n_faces), sizeof(n_faces));
  return bytes.size() == kHeaderBytes + kFacetBytes * std::size_t{n_faces};
}

CheckedInput check_binary(const std::filesystem::path& file, std::string_view bytes) {
  CheckedInput input;
  input.is_binary = true;
  input.n_faces = (bytes.size() - kHeaderBytes) / kFacetBytes;
  for (std::size_t f = 0; f < input.n_faces; ++f) {
    const std::size_t at = kHeaderBytes + f * kFacetBytes;
    std::array<Corner, 3> corners;
    std::memcpy(corners.data(), bytes.data() + at + sizeof(Corner), sizeof(corners));
    check_facet(file, "byte " + std::to_string(at), f, corners);
  }
  input.bytes = bytes;
  return input;
}

void require_words(TextScanner& scanner, std::string_view expected) {
  scanner.require_line(in_quotes(expected));
  std::string words;
  for (auto word = scanner.next_word(); !word.empty(); word = scanner.next_word()) {
    if (!words.empty()) words += ' ';
    words += word;
  }
  if (words != expected)
    scanner.refuse(in_quotes(words) + " where " + in_quotes(expected) + " should be");
}

void check_text_facet(TextScanner& scanner, CheckedInput& input) {
  require_words(scanner, "outer loop");
  const std::string place = scanner.place();
  input.bytes += "outer loop\n";
  std::array<Corner, 3> corners{};
  for (Corner& corner : corners) {
    scanner.require_line("a line 'vertex x y z'");
    if (scanner.next_word() != "vertex") scanner.refuse("a line 'vertex x y z' should be here");
    input.bytes += "vertex";
    for (float& coordinate : corner) {
      coordinate = static_cast<float>(scanner.next_number("a coordinate"));
      input.bytes += ' ';
      input.bytes += scanner.last_word();
    }
    input.bytes += '\n';
  }
  check_facet(scanner.file(), place, input.n_faces, corners);
  require_words(scanner, "endloop");
  require_words(scanner, "endfacet");
  ++input.n_faces;
}

CheckedInput check_text(const std::filesystem::path& file, std::string_view text) {
  TextScanner scanner(file, text);
  CheckedInput input;
  while (scanner.next_line()) {
    if (const auto word = scanner.next_word(); word != "solid") {
      scanner.refuse(in_quotes(word) + " where 'solid' should be");
    }
    for (;;) {
      scanner.require_line("'facet' or 'endsolid'");
      const std::string_view word = scanner.next_word();
      if (word == "endsolid") break;
      if (word != "facet") scanner.refuse(in_quotes(word) + " where 'facet' should be");
      check_text_facet(scanner, input);
    }
  }
  return input;
}

}  // namespace

CheckedInput check_stl(const std::filesystem::path& file, std::string_view bytes) {
  if (has_binary_size(bytes)) return check_binary(file, bytes);
  if (bytes.starts_with("solid")) return check_text(file, bytes);
  refuse_file(file, "byte 80",
              "neither text (it does not start with 'solid') nor binary STL (its size does not "
              "fit its number of faces); it may be cut off");
}

}  // namespace meshgrade
