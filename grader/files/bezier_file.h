#pragma once

#include <filesystem>
#include <vector>

#include "grader/mesh/bezier_data.h"

namespace meshgrade {

/// Reads the control nets of a .bez file: the number of patches, then for each patch its rows
/// of points. A net that is not 4 x 4 has its numbers of rows and columns on a line in front,
/// and each row on a line. Where all are 4 x 4, numbers may stand on any lines.
/// The format is described in docs/formats.md. Throws UserError "<file>:<line>: ...".
std::vector<ControlNet> read_bez(const std::filesystem::path& file);
void write_bez(const std::filesystem::path& file, const std::vector<ControlNet>& patches);

/// Reads the control points of a .bzc file: their number (at least 2), then x and y of each, on
/// any lines.
/// Throws UserError "<file>:<line>: ...".
std::vector<Point2> read_bzc(const std::filesystem::path& file);
void write_bzc(const std::filesystem::path& file, const std::vector<Point2>& points);

}  // namespace meshgrade
