#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <memory>

#include "grader/files/checked_input.h"
#include "grader/files/file_bytes.h"
#include "grader/files/ply_body.h"
#include "grader/files/ply_header.h"
#include "grader/files/triangle_strip.h"
#include "grader/files/utf8_text.h"

namespace meshgrade {
namespace {

using Path = std::filesystem::path;

/// Elements that say nothing of the shape.
constexpr std::array<std::string_view, 5> kNoShapes = {
    "camera", "material", "texture", "multi_texture_vertex", "multi_texture_face"};

/// The plain form that OpenMesh gets: vertices before faces, whatever the file's own order.
struct PlainBody {
  std::string vertices;
  std::string faces;
};

template <typename Number>
void append_raw(std::string& bytes, Number number) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), &number, sizeof(number));
  bytes.append(raw.data(), raw.size());
}

std::size_t list_length(const Path& file, PlyBody& body, const PlyProperty& property) {
  if (!property.list_size) return 1;
  const double length = body.next(*property.list_size, property);
  if (length < 0)
    refuse_file(file, body.place(), "the list " + property.name + " is shorter than 0");
  return static_cast<std::size_t>(length);
}

void skip_property(const Path& file, PlyBody& body, const PlyProperty& property) {
  for (std::size_t left = list_length(file, body, property); left > 0; --left)
    body.skip(property.type);
}

void read_ply_vertex(const Path& file, PlyBody& body, const PlyElement& element,
                     CheckedInput& input, PlainBody& plain) {
  Point3 point{};
  for (const PlyProperty& property : element.properties) {
    const bool is_coordinate = !property.list_size && property.name.size() == 1 &&
                               property.name[0] >= 'x' && property.name[0] <= 'z';
    if (!is_coordinate) {
      skip_property(file, body, property);
      continue;
    }
    point[static_cast<std::size_t>(property.name[0] - 'x')] =
        body.next(property.type, property);
  }
  for (const double coordinate : point)
    append_raw(plain.vertices, coordinate);
  input.exact_positions.push_back(point);
}

/// The lists of vertices of a face or of strips. -1 stays, as the largest number.
std::vector<std::uint32_t> read_corners(const Path& file, PlyBody& body,
                                        const PlyElement& element, const std::string& name) {
  std::vector<std::uint32_t> corners;
  for (const PlyProperty& property : element.properties) {
    if (!property.is_corner_list()) {
      skip_property(file, body, property);
      continue;
    }
    for (std::size_t left = list_length(file, body, property); left > 0; --left) {
      const double v = body.next(property.type, property);
      if (v < 0 && !(v == -1 && element.is_strips())) {
        refuse_file(file, body.place(),
                    name + " asks for vertex " + std::to_string(static_cast<std::int64_t>(v)) +
                        "; PLY counts vertices from 0");
      }
      corners.push_back(v < 0 ? kStripEnd : static_cast<std::uint32_t>(v));
    }
  }
  return corners;
}

void add_face(const Path& file, const std::string& place, std::size_t face,
              std::vector<std::uint32_t> corners, std::size_t n_vertices, CheckedInput& input,
              PlainBody& plain) {
  if (!admit_polygon(file, place, face, corners, n_vertices, 0, input.notes)) return;
  append_raw(plain.faces, static_cast<std::int32_t>(corners.size()));
  for (const std::uint32_t v : corners)
    append_raw(plain.faces, static_cast<std::int32_t>(v));
  ++input.n_faces;
}

void read_element(const Path& file, PlyBody& body, const PlyHeader& header,
                  const PlyElement& element, CheckedInput& input, PlainBody& plain) {
  for (std::uint32_t i = 0; i < element.count; ++i) {
    const std::string name = element.is_vertex() ? "vertex v" + std::to_string(i)
                             : element.is_face() ? "face f" + std::to_string(i)
                                                 : element.name + " " + std::to_string(i);
    body.begin_element(name);
    const std::string place = body.place();
    if (element.is_vertex()) {
      read_ply_vertex(file, body, element, input, plain);
    } else if (element.is_face()) {
      add_face(file, place, i, read_corners(file, body, element, name), header.n_vertices,
               input, plain);
    } else if (element.is_strips()) {
      for (auto& triangle : cut_strips(read_corners(file, body, element, name))) {
        add_face(file, place, input.n_faces, std::move(triangle), header.n_vertices, input,
                 plain);
      }
    } else {
      for (const PlyProperty& property : element.properties)
        skip_property(file, body, property);
    }
    body.end_element(input.notes);
  }
}

void count_other_elements(const PlyHeader& header, ReadingNotes& notes) {
  for (const PlyElement& element : header.elements) {
    const bool is_read = element.is_vertex() || element.is_face() || element.is_strips();
    const bool has_no_shape =
        std::find(kNoShapes.begin(), kNoShapes.end(), element.name) != kNoShapes.end();
    if (is_read || has_no_shape) continue;
    const std::string name = in_quotes(element.name);
    notes.left_out("element " + name, "elements " + name, "", element.count);
  }
}

std::string plain_header(std::size_t n_vertices, std::size_t n_faces) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(n_vertices) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(n_faces) + "\nproperty list int int vertex_indices\nend_header\n";
}

}  // namespace

CheckedInput check_ply(const std::filesystem::path& file, std::string_view bytes) {
  const Utf8Text text(bytes);
  TextScanner scanner(file, text.view(), false);  // numbers may be 1.#QNAN
  const PlyHeader header = read_ply_header(scanner);
  const auto body = open_ply_body(file, text.view(), header.encoding, scanner);

  CheckedInput input;
  input.is_binary = true;
  PlainBody plain;
  for (std::size_t k = 0; k < header.n_needed; ++k) {
    const PlyElement& element = header.elements[k];
    if (!element.properties.empty()) read_element(file, *body, header, element, input, plain);
  }
  if (header.n_needed == header.elements.size()) body->end(input.notes);
  count_other_elements(header, input.notes);
  input.bytes =
      plain_header(input.exact_positions.size(), input.n_faces) + plain.vertices + plain.faces;
  return input;
}

}  // namespace meshgrade
