#pragma once

#include <filesystem>

#include "grader/report/report.h"

namespace meshgrade {

/// Makes the folder for pictures if it is missing.
/// @throws UserError if that is not possible
void make_figure_folder(const std::filesystem::path& folder);

/// Draws every case that there is a picture of, each to an SVG file of its own in `folder`. A
/// file of the same name is written over; nothing else is touched. CaseReport::figure gets the
/// name of its file: "edge_split_boundary_7.svg".
/// @return how many pictures there are
/// @throws UserError if they cannot be written
std::size_t write_figures(Report& report, const std::filesystem::path& folder);

}  // namespace meshgrade
