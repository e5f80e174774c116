#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>

#include "grader/files/checked_input.h"
#include "grader/files/file_bytes.h"
#include "grader/files/text_scanner.h"
#include "grader/files/utf8_text.h"

namespace meshgrade {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kCountAt = 80;
constexpr std::size_t kFacetBytes = 50;
using Corner = std::array<float, 3>;

/// OpenMesh's own measure of "the same point".
bool same_point(const Corner& a, const Corner& b) {
  constexpr float kSmallest = std::numeric_limits<float>::min();
  return std::abs(a[0] - b[0]) <= kSmallest && std::abs(a[1] - b[1]) <= kSmallest &&
         std::abs(a[2] - b[2]) <= kSmallest;
}

/// False for a facet that OpenMesh would drop without a word.
bool admit_facet(const std::filesystem::path& file, const std::string& place, std::size_t face,
                 const std::array<Corner, 3>& corners, ReadingNotes& notes) {
  for (const Corner& corner : corners) {
    for (const float coordinate : corner) {
      if (!std::isfinite(coordinate)) {
        refuse_file(
            file, place,
            "face f" + std::to_string(face) + " has a coordinate that is not a finite number");
      }
    }
  }
  if (!same_point(corners[0], corners[1]) && !same_point(corners[1], corners[2]) &&
      !same_point(corners[2], corners[0])) {
    return true;
  }
  notes.left_out("face without area (two corners at one point)",
                 "faces without area (two corners at one point)", place);
  return false;
}

std::size_t promised_facets(std::string_view bytes) {
  std::uint32_t n_facets = 0;
  std::memcpy(&n_facets, bytes.data() + kCountAt, sizeof(n_facets));
  return n_facets;
}

/// Text never passes: four of its characters, taken as a number, promise more than 2 GiB.
bool holds_promised_facets(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes &&
         bytes.size() - kHeaderBytes >= kFacetBytes * promised_facets(bytes);
}

CheckedInput check_binary(const std::filesystem::path& file, std::string_view bytes) {
  CheckedInput input;
  input.is_binary = true;
  const std::size_t n_promised = promised_facets(bytes);
  input.bytes = bytes.substr(0, kHeaderBytes);
  for (std::size_t f = 0; f < n_promised; ++f) {
    const std::size_t at = kHeaderBytes + f * kFacetBytes;
    std::array<Corner, 3> corners;
    std::memcpy(corners.data(), bytes.data() + at + sizeof(Corner), sizeof(corners));
    if (!admit_facet(file, "byte " + std::to_string(at), f, corners, input.notes)) continue;
    input.bytes += bytes.substr(at, kFacetBytes);
    ++input.n_faces;
  }
  const auto n_faces = static_cast<std::uint32_t>(input.n_faces);
  std::memcpy(input.bytes.data() + kCountAt, &n_faces, sizeof(n_faces));
  const std::size_t end = kHeaderBytes + kFacetBytes * n_promised;
  const std::string promise = std::to_string(n_promised) + " faces that byte 80 promises";
  input.notes.left_out("byte behind the " + promise, "bytes behind the " + promise,
                       "byte " + std::to_string(end), bytes.size() - end);
  return input;
}

/// Reads STL text word by word: the format lets them stand on any line.
class FacetReader {
 public:
  FacetReader(const std::filesystem::path& file, std::string_view text)
      : scanner_(file, text) {}

  CheckedInput read() {
    while (has_more()) {
      const std::string word = next_word("'solid'");
      if (word != "solid") scanner_.refuse(in_quotes(word) + " where 'solid' should be");
      skip_line();  // its name
      read_solid();
    }
    return std::move(input_);
  }

 private:
  bool has_more() { return scanner_.has_word() || scanner_.next_line(); }
  void skip_line() {
    while (!scanner_.next_word().empty()) {
    }
  }
  std::string next_word(const std::string& expected) {
    scanner_.require_word(expected);
    std::string word(scanner_.next_word());
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return word;
  }
  void require(const std::string& expected) {
    const std::string word = next_word(in_quotes(expected));
    if (word != expected) {
      scanner_.refuse(in_quotes(word) + " where " + in_quotes(expected) + " should be");
    }
  }
  /// "endloop", or "end loop".
  void require_end(const std::string& of) {
    std::string word = next_word(in_quotes("end" + of));
    if (word == "end") word += next_word(in_quotes(of));
    if (word == "vertex") scanner_.refuse("a fourth corner; a face of STL has three");
    if (word != "end" + of) {
      scanner_.refuse(in_quotes(word) + " where " + in_quotes("end" + of) + " should be");
    }
  }

  void read_solid() {
    while (has_more()) {
      std::string word = next_word("'facet'");
      if (word == "end") word += next_word("'solid'");
      if (word == "endsolid") return skip_line();
      if (word == "facet") {
        read_facet();
      } else if (word == "solid") {
        skip_line();  // the one before it has no end
      } else if (word == "outer" || word == "vertex" || word == "endloop" ||
                 word == "endfacet") {
        scanner_.refuse(in_quotes(word) + " where 'facet' or 'endsolid' should be");
      } else {
        if (word != "color") {
          input_.notes.left_out("line that is not of STL", "lines that are not of STL",
                                scanner_.place());
        }
        skip_line();
      }
    }
    input_.notes.say("the file ends without 'endsolid'; it may be cut off");
  }

  void read_facet() {
    // A normal follows, which nobody uses.
    std::string word = next_word("'outer loop'");
    while (word != "outer" && word != "vertex" && word != "facet" && word != "endfacet")
      word = next_word("'outer loop'");
    if (word != "outer") scanner_.refuse(in_quotes(word) + " where 'outer loop' should be");
    require("loop");
    const std::string place = scanner_.place();
    std::string plain = "outer loop\n";
    std::array<Corner, 3> corners{};
    for (Corner& corner : corners) {
      require("vertex");
      plain += "vertex";
      for (float& coordinate : corner) {
        scanner_.require_word("a coordinate");
        coordinate = static_cast<float>(scanner_.next_number("a coordinate"));
        plain += ' ';
        plain += scanner_.last_word();
      }
      plain += '\n';
    }
    require_end("loop");
    require_end("facet");
    if (admit_facet(scanner_.file(), place, n_facets_++, corners, input_.notes)) {
      input_.bytes += plain;
      ++input_.n_faces;
    }
  }

  TextScanner scanner_;
  CheckedInput input_;
  std::size_t n_facets_ = 0;
};

bool begins_as_text(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  constexpr std::string_view kSolid = "solid";
  return text.size() >= kSolid.size() && text.substr(0, 512).find('\0') == text.npos &&
         std::equal(kSolid.begin(), kSolid.end(), text.begin(), [](char wanted, char c) {
           return std::tolower(static_cast<unsigned char>(c)) == wanted;
         });
}

}  // namespace

CheckedInput check_stl(const std::filesystem::path& file, std::string_view bytes) {
  if (holds_promised_facets(bytes)) return check_binary(file, bytes);
  const Utf8Text text(bytes);
  if (begins_as_text(text.view())) return FacetReader(file, text.view()).read();
  if (bytes.size() < kHeaderBytes) {
    refuse_file(file, "byte " + std::to_string(bytes.size()),
                "neither text (it does not start with 'solid') nor binary STL (which has 84 "
                "bytes in front of its faces); it may be cut off");
  }
  refuse_file(file, "byte 80",
              "neither text (it does not start with 'solid') nor binary STL (it promises " +
                  std::to_string(promised_facets(bytes)) + " faces, and the " +
                  std::to_string(bytes.size()) + " bytes hold " +
                  std::to_string((bytes.size() - kHeaderBytes) / kFacetBytes) +
                  "); it may be cut off");
}

}  // namespace meshgrade
