#pragma once

// Which edge or face of a student's mesh stands for which expected one, once it is known which
// half-edges are theirs.

#include <vector>

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// An expected edge or face that is to be found.
struct WantedLabel {
  Ref element = kUnsetRef;  ///< by the numbers of the expected mesh
  std::vector<Ref> named;   ///< what the student's half-edges of it name as their own
  std::vector<Ref>
      anchoring;  ///< elements of the student's that anchor one of these half-edges
};

/// Gives each wanted element one of `available`, none twice, such that the fewest pointers are
/// wrong: names of half-edges that differ, and the anchor. Those that are left without one get
/// kUnsetRef. @return the number of wrong pointers; `chosen` is in the order of `wanted`
std::size_t choose_labels(const std::vector<WantedLabel>& wanted,
                          const std::vector<Ref>& available, std::vector<Ref>& chosen);

}  // namespace meshgrade
