#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// A file that is safe to hand to OpenMesh, in the plainest form of its format.
///
/// OpenMesh's readers trust what they read: they follow declared counts into gigabytes, open
/// the material files that a line names, round coordinates to single precision and give no
/// place for a fault. So each file is checked first. Every check throws UserError
/// "<file>:<place>: what is wrong; what to do".
struct CheckedInput {
  std::string bytes;
  bool is_binary = false;
  std::size_t n_faces = 0;
  /// The coordinates in double, in file order. Empty for STL, which has only floats.
  std::vector<Point3> exact_positions;
};

/// Wavefront OBJ: keeps `v` and `f` lines (vertex numbers only); other known lines are dropped.
CheckedInput check_obj(const std::filesystem::path& file, std::string_view text);

/// Object File Format, text, optionally with the prefixes ST, C, N; extra columns are dropped.
CheckedInput check_off(const std::filesystem::path& file, std::string_view text);

/// Polygon file format: ascii and binary of both byte orders; keeps x, y, z and the corners.
CheckedInput check_ply(const std::filesystem::path& file, std::string_view bytes);

/// Stereolithography, text and binary.
CheckedInput check_stl(const std::filesystem::path& file, std::string_view bytes);

}  // namespace meshgrade
