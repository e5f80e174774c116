#include <charconv>
#include <map>
#include <optional>

#include "grader/base/errors.h"
#include "grader/files/checked_input.h"
#include "grader/files/file_bytes.h"
#include "grader/files/text_scanner.h"
#include "grader/files/utf8_text.h"

namespace meshgrade {
namespace {

struct Header {
  std::uint32_t n_vertices = 0;
  std::uint32_t n_faces = 0;
  std::size_t dimension = 3;
  bool is_homogeneous = false;
  bool has_colors = false;
  /// Normals and texture coordinates: numbers behind the position, without the colour.
  std::size_t n_other = 0;

  std::size_t n_position() const { return dimension + (is_homogeneous ? 1 : 0); }
};

/// How vertices and faces lie on the lines.
struct Layout {
  bool line_per_vertex = false;
  bool line_per_face = false;
  /// Numbers of a vertex, where lines do not tell.
  std::size_t vertex_words = 3;
  /// Whether what follows the corners on their line is a colour.
  bool has_face_colors = false;
};

constexpr std::size_t kLongestFaceColor = 4;

/// Takes the prefixes and the word OFF off `word`. What is left are glued counts, or nothing.
std::optional<std::string_view> after_keyword(std::string_view word, Header& header,
                                              bool& has_dimension) {
  const auto take = [&word](std::string_view part) {
    const bool has_part = word.starts_with(part);
    if (has_part) word.remove_prefix(part.size());
    return has_part;
  };
  bool has_normals = false;
  for (bool more = true; more;) {
    if (take("ST")) {
      header.n_other += 2;
    } else if (take("C")) {
      header.has_colors = true;
    } else if (take("N")) {
      has_normals = true;
    } else if (take("4")) {
      header.is_homogeneous = true;
    } else if (take("n")) {
      has_dimension = true;
    } else {
      more = false;
    }
  }
  if (!take("OFF") && !take("off")) return std::nullopt;
  if (has_normals) header.n_other += 3;
  return word;
}

/// The next word as a count; `first` is what stands for it where the keyword was glued to it.
std::uint32_t read_count(TextScanner& scanner, const std::string& what,
                         std::string_view first = {}) {
  if (first.empty()) {
    scanner.require_word(what);
    return scanner.next_index(what);
  }
  std::int64_t number = 0;
  if (!parse_integer(first, number) || number < 0 || number > UINT32_MAX) {
    scanner.refuse(in_quotes(first) + " behind OFF, where " + what + " should be");
  }
  return static_cast<std::uint32_t>(number);
}

void read_edge_count(TextScanner& scanner) {
  // Nobody uses it. It may be missing, and may stand on a line of its own.
  if (scanner.has_word()) {
    scanner.next_word();
    return;
  }
  TextScanner ahead = scanner;
  if (ahead.next_line() && ahead.count_words() == 1) {
    scanner.next_line();
    scanner.next_word();
  }
}

void read_dimension(TextScanner& scanner, Header& header) {
  header.dimension = read_count(scanner, "the number of dimensions");
  if (header.dimension < 1 || header.dimension > 3) {
    scanner.refuse("vertices of " + std::to_string(header.dimension) +
                   " dimensions; 1 to 3 are read");
  }
}

Header read_header(TextScanner& scanner) {
  Header header;
  scanner.require_line("the word OFF");
  TextScanner ahead = scanner;
  const std::string_view word = ahead.next_word();
  std::int64_t number = 0;
  bool has_dimension = false;
  std::string_view glued;
  if (!parse_integer(word, number)) {
    const auto rest = after_keyword(word, header, has_dimension);
    if (!rest) {
      scanner.refuse(in_quotes(word) +
                     " where the word OFF should be; known are [ST][C][N][4][n]OFF");
    }
    glued = *rest;
    scanner = ahead;
    if (ahead.next_word() == "BINARY") {
      scanner.refuse("binary OFF is not read; save it as text");
    }
  }
  if (has_dimension) read_dimension(scanner, header);
  header.n_vertices = read_count(scanner, "the number of vertices", glued);
  header.n_faces = read_count(scanner, "the number of faces");
  read_edge_count(scanner);
  return header;
}

void append_exact(std::string& text, double number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), end.ptr);
}

void read_off_vertex(TextScanner& scanner, const Header& header, const Layout& layout,
                     CheckedInput& input) {
  const std::string name = "vertex v" + std::to_string(input.exact_positions.size());
  if (layout.line_per_vertex) scanner.require_line(name);
  const auto number = [&] {
    if (!layout.line_per_vertex) scanner.require_word(name);
    return scanner.next_number("a coordinate");
  };
  Point3 point{};
  for (std::size_t axis = 0; axis < header.dimension; ++axis)
    point[axis] = number();
  if (header.is_homogeneous) {
    const double w = number();
    if (w == 0) scanner.refuse(name + " lies at infinity (its fourth number is 0)");
    for (double& coordinate : point)
      coordinate /= w;
  }
  for (std::size_t k = header.n_position(); k < layout.vertex_words; ++k) {
    scanner.require_word(name);
    scanner.next_word();
  }
  for (const double coordinate : point) {
    append_exact(input.bytes, coordinate);
    input.bytes += ' ';
  }
  input.bytes.back() = '\n';
  input.exact_positions.push_back(point);
}

/// Polygons need three corners; Geomview takes one for a point and two for a line.
void read_off_face(TextScanner& scanner, std::size_t face, const Layout& layout,
                   CheckedInput& input) {
  const std::string name = "face f" + std::to_string(face);
  if (layout.line_per_face) {
    scanner.require_line(name);
  } else {
    scanner.require_word(name);
  }
  const std::string place = scanner.place();
  const std::uint32_t n_corners = scanner.next_index("the number of corners");
  if (n_corners == 0) {
    scanner.refuse(name + " has 0 corners; do the counts at the top fit the file?");
  }
  std::vector<std::uint32_t> corners;
  for (std::uint32_t k = 0; k < n_corners; ++k) {
    if (!layout.line_per_face && !scanner.has_word()) {
      scanner.require_line("a corner of " + name);
    }
    corners.push_back(scanner.next_index("a vertex number"));
  }
  for (std::size_t k = 0; layout.has_face_colors && scanner.has_word(); ++k) {
    scanner.next_word();
    if (!layout.line_per_face && k == kLongestFaceColor) {
      scanner.refuse(in_quotes(scanner.last_word()) + " behind " + name);
    }
  }
  const std::size_t n_vertices = input.exact_positions.size();
  if (!admit_polygon(scanner.file(), place, face, corners, n_vertices, 0, input.notes)) {
    return;
  }
  input.bytes += std::to_string(corners.size());
  for (const std::uint32_t v : corners)
    input.bytes += ' ' + std::to_string(v);
  input.bytes += '\n';
  ++input.n_faces;
}

struct Attempt {
  CheckedInput input;
  bool is_exact = false;
  std::optional<UserError> fault;
};

Attempt attempt(TextScanner scanner, const Header& header, const Layout& layout) {
  Attempt result;
  CheckedInput& input = result.input;
  try {
    for (std::uint32_t v = 0; v < header.n_vertices; ++v)
      read_off_vertex(scanner, header, layout, input);
    if (layout.line_per_vertex) {
      while (scanner.has_word())
        scanner.next_word();
    }
    for (std::uint32_t f = 0; f < header.n_faces; ++f)
      read_off_face(scanner, f, layout, input);
    result.is_exact = !scanner.has_word() && !scanner.next_line();
    if (!result.is_exact) {
      std::size_t n_lines = 1;
      const std::string place = scanner.place();
      while (scanner.next_line())
        ++n_lines;
      input.notes.left_out("line more than the counts at the top promise",
                           "lines more than the counts at the top promise", place, n_lines);
    }
  } catch (const UserError& error) {
    result.fault = error;
  }
  return result;
}

/// Whether vertices and faces seem to stand on lines of their own. If so, a line with too few
/// numbers for a vertex is a fault, and never the first half of one.
bool lines_tell(TextScanner scanner, const Header& header) {
  std::map<std::size_t, std::size_t> lines_with;
  std::size_t n_lines = 0;
  for (; scanner.next_line(); ++n_lines) {
    if (n_lines < header.n_vertices) ++lines_with[scanner.count_words()];
  }
  if (n_lines <= header.n_vertices) return false;
  for (const auto& [n_words, count] : lines_with) {
    if (n_words >= header.n_position() && 2 * count > header.n_vertices) return true;
  }
  return false;
}

bool has_short_vertex_line(TextScanner scanner, const Header& header) {
  for (std::uint32_t v = 0; v < header.n_vertices && scanner.next_line(); ++v) {
    if (scanner.count_words() < header.n_position()) return true;
  }
  return false;
}

/// The ways in which the words may be meant, the likeliest first.
std::vector<Layout> layouts_of(const Header& header, bool by_lines) {
  std::vector<Layout> layouts;
  const auto add_words = [&layouts](bool line_per_vertex, std::size_t n_words) {
    layouts.push_back({line_per_vertex, false, n_words, true});
    layouts.push_back({line_per_vertex, false, n_words, false});
  };
  if (by_lines) {
    layouts.push_back({true, true, header.n_position(), true});
    add_words(true, header.n_position());
  }
  const std::size_t least = header.n_position() + header.n_other;
  if (header.has_colors) {
    add_words(false, least + 4);  // Geomview has four, others write three
    add_words(false, least + 3);
  } else {
    add_words(false, least);
  }
  return layouts;
}

}  // namespace

CheckedInput check_off(const std::filesystem::path& file, std::string_view bytes) {
  const Utf8Text text(bytes);
  TextScanner scanner(file, text.view());
  const Header header = read_header(scanner);

  const bool by_lines = lines_tell(scanner, header);
  std::vector<Layout> layouts = layouts_of(header, by_lines);
  if (by_lines && has_short_vertex_line(scanner, header)) layouts.resize(1);
  std::optional<Attempt> best;
  for (const Layout& layout : layouts) {
    Attempt result = attempt(scanner, header, layout);
    // Where lines tell, another reading must use up every word: anything may be shifted.
    if (!best || result.is_exact || (!by_lines && best->fault && !result.fault)) {
      best = std::move(result);
    }
    if (best->is_exact) break;
  }
  if (best->fault) throw UserError(*best->fault);
  best->input.bytes.insert(0, "OFF\n" + std::to_string(header.n_vertices) + ' ' +
                                  std::to_string(best->input.n_faces) + " 0\n");
  return std::move(best->input);
}

}  // namespace meshgrade
