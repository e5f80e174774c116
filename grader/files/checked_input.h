#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "grader/files/reading_notes.h"
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
  ReadingNotes notes;
};

/// Wavefront OBJ: keeps the lines `v` and `f`, vertex numbers only, and the older `fo`. Lines
/// of colours, groups and the like are dropped; lines, points and free-form curves are counted.
CheckedInput check_obj(const std::filesystem::path& file, std::string_view bytes);

/// Geomview's Object File Format in text: [ST][C][N][4][n]OFF, or no such word. Words may stand
/// on any line; where lines tell one vertex or face each, columns behind it are dropped.
/// Vertices of one or two dimensions get zeros, homogeneous ones are divided by the fourth.
CheckedInput check_off(const std::filesystem::path& file, std::string_view bytes);

/// Polygon file format: ascii, with an element on each line, and binary of both byte orders.
/// Keeps x, y, z and the corners of faces and triangle strips, in any order of elements.
CheckedInput check_ply(const std::filesystem::path& file, std::string_view bytes);

/// Stereolithography. Binary is what is long enough for its number of facets, as text never is;
/// text is words on any line, in upper or lower case.
CheckedInput check_stl(const std::filesystem::path& file, std::string_view bytes);

}  // namespace meshgrade
