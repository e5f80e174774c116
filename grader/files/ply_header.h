#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grader/files/text_scanner.h"

namespace meshgrade {

/// A number type of PLY, such as uchar or float64.
struct PlyScalar {
  std::string_view name;
  std::size_t size;
  bool is_float;
  bool is_signed;
};

struct PlyProperty {
  std::string name;
  PlyScalar type{};
  std::optional<PlyScalar> list_size;  // of a list only

  /// Whether it is a list of the vertices of a face or strip.
  bool is_corner_list() const;
};

struct PlyElement {
  std::string name;
  std::uint32_t count = 0;
  std::vector<PlyProperty> properties;

  bool is_vertex() const { return name == "vertex"; }
  bool is_face() const { return name == "face"; }
  bool is_strips() const { return name == "tristrips"; }
};

enum class PlyEncoding { kText, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kText;
  std::vector<PlyElement> elements;
  std::uint32_t n_vertices = 0;
  /// Elements up to the last that a mesh is made of.
  std::size_t n_needed = 0;
};

/// Reads up to and with the line end_header. There is one element vertex with x, y and z, and
/// at least one of faces or strips with a list of corners. Throws UserError otherwise.
PlyHeader read_ply_header(TextScanner& scanner);

}  // namespace meshgrade
