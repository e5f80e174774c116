#include <algorithm>
#include <array>
#include <utility>

#include "grader/files/checked_input.h"
#include "grader/files/file_bytes.h"
#include "grader/files/text_scanner.h"
#include "grader/files/utf8_text.h"

namespace meshgrade {
namespace {

/// Words of the format that say nothing of the shape, or belong to a curve or surface that is
/// counted itself.
constexpr std::array<std::string_view, 38> kPassedOver = {
    "vt",   "vn",       "vp",         "vc",        "vw",     "g",     "o",      "s",
    "mg",   "mtllib",   "usemtl",     "usemap",    "maplib", "bevel", "lod",    "c_interp",
    "csh",  "d_interp", "shadow_obj", "trace_obj", "ctech",  "stech", "cstype", "deg",
    "bmat", "step",     "parm",       "trim",      "hole",   "scrv",  "sp",     "end",
    "con",  "res",      "usemat",     "matlib",    "illum",  "curv2"};

/// Words of the format that carry shapes which are no polygons.
struct OtherShape {
  std::string_view keyword;
  const char* one;
  const char* many;
};
constexpr std::array<OtherShape, 9> kOtherShapes = {{
    {"l", "line", "lines"},
    {"p", "point", "points"},
    {"curv", "free-form curve", "free-form curves"},
    {"surf", "free-form surface", "free-form surfaces"},
    {"cdc", "free-form curve", "free-form curves"},
    {"bsp", "free-form surface", "free-form surfaces"},
    {"bzp", "free-form surface", "free-form surfaces"},
    {"cdp", "free-form surface", "free-form surfaces"},
    {"call", "other file ('call')", "other files ('call')"},
}};

/// A face as its line names it. It may name vertices that come later.
struct NamedFace {
  std::string place;
  std::vector<std::uint32_t> corners;
};

/// The first line that starts with no word of the format.
struct UnknownLine {
  std::string place;
  std::string keyword;
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

NamedFace read_named_face(TextScanner& scanner, std::size_t n_vertices_so_far) {
  NamedFace face{scanner.place(), {}};
  for (auto word = scanner.next_word(); !word.empty(); word = scanner.next_word())
    face.corners.push_back(corner_vertex(scanner, word, n_vertices_so_far));
  return face;
}

/// Counts what is no polygon. False if the word is none of the format.
bool count_other_line(const TextScanner& scanner, std::string_view keyword,
                      ReadingNotes& notes) {
  const auto shape =
      std::find_if(kOtherShapes.begin(), kOtherShapes.end(),
                   [&](const OtherShape& other) { return other.keyword == keyword; });
  if (shape != kOtherShapes.end()) {
    const std::size_t count = keyword == "p" ? scanner.count_words() : 1;
    notes.left_out(shape->one, shape->many, scanner.place(), count);
    return true;
  }
  return std::find(kPassedOver.begin(), kPassedOver.end(), keyword) != kPassedOver.end();
}

/// Puts a line that goes on after a backslash onto one line. Empty lines follow it, so that
/// the lines after it keep their numbers. Comments end with their line.
std::string join_lines(std::string_view text) {
  std::string joined;
  std::size_t moved = 0;
  while (!text.empty()) {
    std::string_view line = take_line(text);
    const std::size_t last = line.find_last_not_of(" \t");
    const bool goes_on =
        last != line.npos && line[last] == '\\' && line.find('#') == line.npos && !text.empty();
    joined += goes_on ? line.substr(0, last) : line;
    joined += goes_on ? ' ' : '\n';
    moved += goes_on ? 1 : 0;
    if (!goes_on) joined.append(std::exchange(moved, 0), '\n');
  }
  return joined;
}

void admit_faces(const std::filesystem::path& file, std::vector<NamedFace>& faces,
                 CheckedInput& input) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    auto& [place, corners] = faces[f];
    if (!admit_polygon(file, place, f, corners, input.exact_positions.size(), 1, input.notes)) {
      continue;
    }
    input.bytes += 'f';
    for (const std::uint32_t v : corners)
      input.bytes += ' ' + std::to_string(v + 1);
    input.bytes += '\n';
    ++input.n_faces;
  }
}

}  // namespace

CheckedInput check_obj(const std::filesystem::path& file, std::string_view bytes) {
  const Utf8Text utf8(bytes);
  std::string_view text = utf8.view();
  std::string joined;
  if (text.find('\\') != std::string_view::npos) text = joined = join_lines(text);
  TextScanner scanner(file, text);
  CheckedInput input;
  std::vector<NamedFace> faces;
  UnknownLine unknown;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.next_word();
    if (keyword == "v") {
      check_vertex(scanner, input);
    } else if (keyword == "f" || keyword == "fo") {
      faces.push_back(read_named_face(scanner, input.exact_positions.size()));
    } else if (!count_other_line(scanner, keyword, input.notes)) {
      if (unknown.place.empty()) unknown = {scanner.place(), in_quotes(keyword)};
      input.notes.left_out("line that starts with no word of OBJ (" + unknown.keyword + ")",
                           "lines that start with no word of OBJ (" + unknown.keyword + " ...)",
                           scanner.place());
    }
  }
  if (faces.empty() && !unknown.place.empty()) {
    refuse_file(file, unknown.place,
                unknown.keyword + " starts no line of an OBJ file, and no line is a face; is " +
                    "it another format?");
  }
  admit_faces(file, faces, input);
  return input;
}

}  // namespace meshgrade
