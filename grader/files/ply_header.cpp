#include "grader/files/ply_header.h"

#include <algorithm>
#include <array>

#include "grader/files/file_bytes.h"

namespace meshgrade {
namespace {

constexpr std::array<PlyScalar, 16> kScalars = {{{"char", 1, false, true},
                                                 {"int8", 1, false, true},
                                                 {"uchar", 1, false, false},
                                                 {"uint8", 1, false, false},
                                                 {"short", 2, false, true},
                                                 {"int16", 2, false, true},
                                                 {"ushort", 2, false, false},
                                                 {"uint16", 2, false, false},
                                                 {"int", 4, false, true},
                                                 {"int32", 4, false, true},
                                                 {"uint", 4, false, false},
                                                 {"uint32", 4, false, false},
                                                 {"float", 4, true, true},
                                                 {"float32", 4, true, true},
                                                 {"double", 8, true, true},
                                                 {"float64", 8, true, true}}};

bool is_comment(std::string_view keyword) {
  return keyword == "comment" || keyword == "obj_info";
}

PlyScalar read_scalar(TextScanner& scanner) {
  const std::string_view word = scanner.next_word();
  const auto found = std::find_if(kScalars.begin(), kScalars.end(),
                                  [&](const PlyScalar& scalar) { return scalar.name == word; });
  if (found == kScalars.end()) scanner.refuse(in_quotes(word) + " is no PLY number type");
  return *found;
}

PlyProperty read_property(TextScanner& scanner) {
  PlyProperty property;
  TextScanner ahead = scanner;
  if (ahead.next_word() == "list") {
    scanner.next_word();
    property.list_size = read_scalar(scanner);
    if (property.list_size->is_float) scanner.refuse("a list's length must be a whole number");
  }
  property.type = read_scalar(scanner);
  property.name = scanner.next_word();
  return property;
}

PlyEncoding read_encoding(TextScanner& scanner) {
  do {
    scanner.require_line("the line 'format ...'");
  } while (is_comment(scanner.next_word()));
  if (scanner.last_word() != "format") scanner.refuse("the line 'format ...' should be here");
  const std::string_view word = scanner.next_word();
  if (word == "ascii") return PlyEncoding::kText;
  if (word == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (word == "binary_big_endian") return PlyEncoding::kBigEndian;
  scanner.refuse(in_quotes(word) + " is no PLY encoding");
}

void check_vertex_element(const TextScanner& scanner, const PlyElement& element) {
  for (const std::string axis : {"x", "y", "z"}) {
    const bool has_axis =
        std::any_of(element.properties.begin(), element.properties.end(),
                    [&](const PlyProperty& property) { return property.name == axis; });
    if (!has_axis) scanner.refuse("the vertices have no property " + axis);
  }
}

void check_elements(const TextScanner& scanner, PlyHeader& header) {
  bool has_vertices = false;
  bool has_faces = false;
  for (std::size_t k = 0; k < header.elements.size(); ++k) {
    const PlyElement& element = header.elements[k];
    if (element.is_vertex()) {
      if (has_vertices) scanner.refuse("two elements are called vertex");
      check_vertex_element(scanner, element);
      has_vertices = true;
      header.n_vertices = element.count;
    } else if (element.is_face() || element.is_strips()) {
      has_faces = true;
      if (std::none_of(element.properties.begin(), element.properties.end(),
                       [](const PlyProperty& property) { return property.is_corner_list(); })) {
        scanner.refuse("the element " + element.name + " has no list vertex_indices");
      }
    } else {
      continue;
    }
    header.n_needed = k + 1;
  }
  if (!has_vertices) scanner.refuse("the header names no element vertex");
  if (!has_faces) {
    scanner.refuse("the header names no element face or tristrips; only surfaces are read");
  }
}

}  // namespace

bool PlyProperty::is_corner_list() const {
  return list_size && !type.is_float && (name == "vertex_indices" || name == "vertex_index");
}

PlyHeader read_ply_header(TextScanner& scanner) {
  scanner.require_line("the word ply");
  if (const auto word = scanner.next_word(); word != "ply" && word != "PLY") {
    scanner.refuse(in_quotes(word) + " where the word ply should be; is it another format?");
  }
  PlyHeader header;
  header.encoding = read_encoding(scanner);
  for (;;) {
    scanner.require_line("'end_header'");
    const std::string_view keyword = scanner.next_word();
    if (keyword == "end_header") break;
    if (keyword == "element") {
      PlyElement element;
      element.name = scanner.next_word();
      element.count = scanner.next_index("the number of elements");
      header.elements.push_back(std::move(element));
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (!is_comment(keyword)) {
      scanner.refuse(in_quotes(keyword) + " does not belong in a PLY header");
    }
  }
  check_elements(scanner, header);
  return header;
}

}  // namespace meshgrade
