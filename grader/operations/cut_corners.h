#pragma once

#include "grader/operations/local_operation.h"

namespace meshgrade {

/// Some vertices, joined by an edge if they are two, become a face: each edge that led away
/// from them gets a vertex of its own where its old end was, and these are the corners of the
/// face, in the order of the edges around. At a boundary, one side of the face lies on it.
/// @return the answer, not settled; the face may have fewer than three corners
Answer cut_corners(const FaceLists& before, const Corners& vertices);

}  // namespace meshgrade
