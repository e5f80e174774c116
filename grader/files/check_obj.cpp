#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "grader/files/checked_input.h"
#include "grader/files/file_bytes.h"
#include "grader/files/text_scanner.h"

namespace meshgrade {
namespace {

constexpr std::array<std::string_view, 26> kIgnoredKeywords = {
    "vt",    "vn",       "vp",       "vc",     "g",          "o",         "s",
    "mg",    "l",        "p",        "mtllib", "usemtl",     "usemap",    "maplib",
    "bevel", "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj", "cstype",
    "deg",   "curv",     "surf",     "parm",   "end"};

/// A face that names a vertex which had not come yet when its line was read.
struct ForwardFace {
  std::string place;
  std::size_t face;
  std::vector<std::uint32_t> corners;
};

/// The vertex of "7", "7/1", "7//3", "-2": counted from 0.
std::uint32_t corner_vertex(const TextScanner& scanner, std::string_view word,
                            std::size_t n_vertices_so_far) {
  const std::string_view digits = word.substr(0, word.find('/'));
  std::int64_t number = 0;
  if (!parse_integer(digits, number) || number > INT32_MAX || number < -INT32_MAX) {
    scanner.refuse(in_quotes(word) +
                   " where a vertex number should be; OBJ counts 1, 2, 3, ...");
  }
  if (number == 0) scanner.refuse("vertex number 0; OBJ counts vertices from 1");
  if (number > 0) return static_cast<std::uint32_t>(number - 1);
  const std::int64_t index = static_cast<std::int64_t>(n_vertices_so_far) + number;
  if (index < 0) {
    scanner.refuse("vertex number " + std::to_string(number) +
                   " counts back past the first of " + std::to_string(n_vertices_so_far) +
                   " vertices");
  }
  return static_cast<std::uint32_t>(index);
}

void check_vertex(TextScanner& scanner, CheckedInput& input) {
  input.bytes += 'v';
  Point3 point{};
  for (double& coordinate : point) {
    coordinate = scanner.next_number("a coordinate");
    input.bytes += ' ';
    input.bytes += scanner.last_word();
  }
  input.bytes += '\n';
  input.exact_positions.push_back(point);
}

void check_face(TextScanner& scanner, CheckedInput& input, std::vector<ForwardFace>& forward) {
  const std::size_t n_so_far = input.exact_positions.size();
  std::vector<std::uint32_t> corners;
  input.bytes += 'f';
  for (auto word = scanner.next_word(); !word.empty(); word = scanner.next_word()) {
    corners.push_back(corner_vertex(scanner, word, n_so_far));
    input.bytes += ' ';
    input.bytes += word.substr(0, word.find('/'));
  }
  input.bytes += '\n';
  const bool is_forward = std::any_of(corners.begin(), corners.end(),
                                      [&](std::uint32_t v) { return v >= n_so_far; });
  if (is_forward) {
    forward.push_back({scanner.place(), input.n_faces, std::move(corners)});
  } else {
    check_polygon(scanner.file(), scanner.place(), input.n_faces, corners, n_so_far, 1);
  }
  ++input.n_faces;
}

/// Puts a line that goes on after a backslash onto one line. Empty lines follow it, so that
/// the lines after it keep their numbers. Comments end with their line.
std::string join_lines(std::string_view text) {
  std::string joined;
  std::size_t moved = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    const bool goes_on =
        line.ends_with('\\') && line.find('#') == std::string_view::npos && !text.empty();
    joined += goes_on ? line.substr(0, line.size() - 1) : line;
    joined += goes_on ? ' ' : '\n';
    moved += goes_on ? 1 : 0;
    if (!goes_on) joined.append(std::exchange(moved, 0), '\n');
  }
  return joined;
}

}  // namespace

CheckedInput check_obj(const std::filesystem::path& file, std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::string joined;
  if (text.find('\\') != std::string_view::npos) text = joined = join_lines(text);
  TextScanner scanner(file, text);
  CheckedInput input;
  std::vector<ForwardFace> forward;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.next_word();
    if (keyword == "v") {
      check_vertex(scanner, input);
    } else if (keyword == "f") {
      check_face(scanner, input, forward);
    } else if (std::find(kIgnoredKeywords.begin(), kIgnoredKeywords.end(), keyword) ==
               kIgnoredKeywords.end()) {
      scanner.refuse(in_quotes(keyword) +
                     " starts no line of an OBJ file; is it another format?");
    }
  }
  for (const ForwardFace& face : forward) {
    check_polygon(file, face.place, face.face, face.corners, input.exact_positions.size(), 1);
  }
  return input;
}

}  // namespace meshgrade
