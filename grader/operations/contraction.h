#pragma once

#include "grader/operations/local_operation.h"

namespace meshgrade {

/// What is said of the reasons against a contraction.
struct ContractionReasons {
  const char* boundary;      ///< it touches the boundary in more than one place
  const char* other_face;    ///< a face that does not lie beside it has two of its corners
  const char* third_corner;  ///< what vanishes beside it would leave a vertex with one edge
};

/// An edge, or a face, becomes one vertex, in the middle of its corners. A face beside it of
/// which only one other corner is left vanishes, and its two sides become one edge.
///
/// Topologically that is always a surface if what is contracted touches the boundary in one
/// place at most. What is asked besides: every face visits the new vertex once (no other face
/// has two of the corners, no other edge joins two of them), and no vertex is left with one
/// edge.
Answer contract(const FaceLists& before, const Corners& corners,
                const ContractionReasons& reasons);

}  // namespace meshgrade
