#pragma once

#include <filesystem>
#include <vector>

#include "grader/report/report.h"

namespace meshgrade {

/// A folder for pictures, with those above it. What was made and is still empty in the end goes
/// again; a folder that was there before stays.
class FigureFolder {
 public:
  /// No folder for an empty path.
  /// @throws UserError if it cannot be made
  explicit FigureFolder(const std::filesystem::path& folder);
  ~FigureFolder();
  FigureFolder(const FigureFolder&) = delete;
  FigureFolder& operator=(const FigureFolder&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< the innermost first
};

/// Draws every case that there is a picture of, each to an SVG file of its own in `folder`. A
/// file of the same name is written over; nothing else is touched. CaseReport::figure gets the
/// name of its file: "edge_split_boundary_7.svg".
/// @return how many pictures there are
/// @throws UserError if they cannot be written
std::size_t write_figures(Report& report, const std::filesystem::path& folder);

}  // namespace meshgrade
