#pragma once

// Which element of a student's mesh stands for which element of a right answer.

#include <vector>

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// From the elements of the expected mesh to those of the student's mesh; kUnsetRef where the
/// student has none. Elements that are not free stand for themselves.
struct Correspondence {
  std::vector<Ref> halfedges;
  std::vector<Ref> vertices;
  std::vector<Ref> edges;
  std::vector<Ref> faces;

  /// The student's name for an expected face or boundary loop.
  Ref face(Ref expected) const {
    return (expected & kBoundaryBit) != 0 ? expected : faces[expected];
  }
};

/// Finds the correspondence with the fewest wrong pointers, over all right answers: any
/// half-edge around `edge`, old or new, may take any place, and so may the faces beside it, and
/// after a split `edge` itself. Vertices and all other edges stand for themselves.
///
/// @param before, expected  keep all mesh rules
/// @param after  may be broken in any way
/// @param split_vertex  the new vertex of `expected`, unset after a flip
Correspondence find_correspondence(const MeshDump& before, const MeshDump& after,
                                   const MeshDump& expected, Ref edge, Ref split_vertex);

}  // namespace meshgrade
