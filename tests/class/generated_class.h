#pragma once

// A class that is made for the test: known-right, known-wrong, non-compiling, crashing,
// endless, hostile and empty submissions, each with the points that it must get for edge_flip.

#include <filesystem>
#include <string>
#include <vector>

namespace meshgrade {

/// The points that a submission must get: one number unless the two differ.
struct PointsRange {
  double least = 0.0;
  double most = 0.0;
};

/// One student and what must come of their work.
struct GeneratedStudent {
  std::string id;                ///< "student017"
  std::string kind;              ///< "wrong/edge_flip/next_wrong"
  std::filesystem::path folder;  ///< what was handed in
  std::string status;            ///< "graded" or "ungradable"
  PointsRange points;            ///< of the 20 for edge_flip
  std::string verdict;           ///< of the exercise; empty if ungradable
};

/// Makes folders for `count` students in `folder`, going round through all kinds.
std::vector<GeneratedStudent> generate_class(const std::filesystem::path& folder,
                                             std::size_t count);

/// Writes the assignment that they are graded by: edge_flip only, with tight limits.
std::filesystem::path write_class_assignment(const std::filesystem::path& file);

}  // namespace meshgrade
