#pragma once

// What splits and collapses have left behind, found again by where its vertices lie.

#include <optional>
#include <string>
#include <vector>

#include "grader/cases/remesh_input.h"
#include "grader/judge/finding.h"
#include "grader/operations/face_lists.h"

namespace meshgrade {

/// The right result of splits and collapses, before anything is flipped or smoothed.
struct Resizing {
  const FaceLists& before;
  const RemeshSettings& settings;
  const FaceLists& after;
  double allowed;  ///< how far a vertex may be off
};

/// Which labels are corners of a face.
std::vector<bool> labels_in_use(const FaceLists& lists);

/// The label of each live vertex of a mesh, by its place.
/// @return nothing if the vertices are not those of the lists
std::optional<std::vector<Label>> labels_by_place(const MeshDump& mesh, const FaceLists& lists,
                                                  double allowed);

/// What is wrong where labels_by_place() finds none: an edge that had to be split or collapsed
/// and was not, or the other way round.
/// @param mesh  keeps all mesh rules; nothing has been smoothed
Finding wrong_resizing(const Resizing& right, const MeshDump& mesh);

}  // namespace meshgrade
