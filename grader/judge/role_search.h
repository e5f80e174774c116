#pragma once

// Which half-edge of a student's mesh plays which part of a right answer: the assignment that
// leaves the fewest pointers wrong, found by branch and bound (Land and Doig 1960).

#include <cstddef>
#include <vector>

#include "grader/judge/correspondence.h"

namespace meshgrade {

/// What may stand for what. Everything else stands for itself.
struct FreeElements {
  std::vector<Ref> expected;  ///< parts to be given away, by the numbers of the expected mesh
  std::vector<Ref> actual;    ///< live elements of the student's mesh that may take them
};

struct RoleProblem {
  const MeshDump& after;
  const MeshDump& expected;
  FreeElements halfedges;
  FreeElements edges;
  FreeElements faces;
  Ref split_vertex = kUnsetRef;  ///< of `expected`; must anchor a half-edge along the old edge
  std::vector<Ref> along;        ///< those half-edges of `expected`
};

/// Takes the vertices from `start`, and gives away the free half-edges, edges and faces such
/// that the fewest pointers are wrong. A part that nobody is left for has all of its pointers
/// wrong. The minimum is the true one but for meshes in which nearly nothing is right: there
/// the search ends after some milliseconds with the best that it has seen.
///
/// @param bound  only what is better than this many wrong pointers is of interest
/// @return the number of wrong pointers, `bound` if nothing better was found; `start` holds the
///         assignment then
std::size_t assign_roles(const RoleProblem& problem, std::size_t bound, Correspondence& start);

}  // namespace meshgrade
