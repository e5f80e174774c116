#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/build/build.h"
#include "grader/build/home.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// Functions whose right solution takes the place of the student's.
struct StandIn {
  std::string exercise;  ///< "edge_split": names the file of the reference
  /// "HalfedgeMesh::splitEdge": taken out of the submission
  std::vector<std::string> functions;
  /// What else the file of the reference defines: these stay the student's own.
  std::vector<std::string> kept = {};
  /// A text of the reference and what stands in its place; both empty for the reference itself.
  std::string was = "";
  std::string becomes = "";
  std::string folder = "";  ///< of the reference, in which the file is: Assignment::folder
};

/// The submission with these exercises taken out of its files and the reference's files put in,
/// so that what calls them can be judged on its own.
/// @return nothing if this package comes without the reference, or if that has not the text
/// that
///         is to be changed
/// @throws GraderError if a file of the reference cannot be read
std::optional<Submission> with_stand_ins(Submission submission, const Home& home,
                                         const std::vector<StandIn>& stand_ins);

/// Whether the stand-ins are really part of what was built. They are not when the student's own
/// function stands where it is not found, made by a macro for example.
bool has_stand_ins(const Build& build, const std::vector<StandIn>& stand_ins);

}  // namespace meshgrade
