#include "grader/files/checked_input.h"
#include "grader/files/file_bytes.h"
#include "grader/files/text_scanner.h"

namespace meshgrade {
namespace {

void check_header(TextScanner& scanner) {
  scanner.require_line("the word OFF");
  const std::string_view word = scanner.next_word();
  if (word != "OFF" && word != "COFF" && word != "NOFF" && word != "CNOFF" && word != "STOFF" &&
      word != "STCNOFF") {
    scanner.refuse(in_quotes(word) + " where the word OFF should be; only OFF in 3D is read");
  }
  if (const std::string_view more = scanner.next_word(); more == "BINARY") {
    scanner.refuse("binary OFF is not read; save it as text");
  } else if (!more.empty()) {
    scanner.refuse(in_quotes(more) + " behind OFF; the counts belong on a line of their own");
  }
}

void check_vertex(TextScanner& scanner, CheckedInput& input) {
  scanner.require_line("vertex v" + std::to_string(input.exact_positions.size()));
  Point3 point{};
  for (double& coordinate : point) {
    coordinate = scanner.next_number("a coordinate");
    input.bytes += scanner.last_word();
    input.bytes += ' ';
  }
  input.bytes.back() = '\n';
  input.exact_positions.push_back(point);
}

void check_face(TextScanner& scanner, std::size_t face, CheckedInput& input) {
  scanner.require_line("face f" + std::to_string(face));
  const std::uint32_t n_corners = scanner.next_index("the number of corners");
  input.bytes += std::to_string(n_corners);
  std::vector<std::uint32_t> corners;
  for (std::uint32_t k = 0; k < n_corners; ++k) {
    corners.push_back(scanner.next_index("a vertex number"));
    input.bytes += ' ' + std::to_string(corners.back());
  }
  input.bytes += '\n';
  check_polygon(scanner.file(), scanner.place(), face, corners, input.exact_positions.size(),
                0);
}

}  // namespace

CheckedInput check_off(const std::filesystem::path& file, std::string_view text) {
  TextScanner scanner(file, text);
  check_header(scanner);
  scanner.require_line("the numbers of vertices, faces and edges");
  const std::uint32_t n_vertices = scanner.next_index("the number of vertices");
  const std::uint32_t n_faces = scanner.next_index("the number of faces");

  CheckedInput input;
  input.n_faces = n_faces;
  input.bytes = "OFF\n" + std::to_string(n_vertices) + ' ' + std::to_string(n_faces) + " 0\n";
  for (std::uint32_t v = 0; v < n_vertices; ++v)
    check_vertex(scanner, input);
  for (std::uint32_t f = 0; f < n_faces; ++f)
    check_face(scanner, f, input);
  if (scanner.next_line()) {
    scanner.refuse("more lines than the counts at the top promise; correct the counts");
  }
  return input;
}

}  // namespace meshgrade
