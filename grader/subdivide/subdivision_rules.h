#pragma once

#include <functional>

#include "grader/base/errors.h"

namespace meshgrade {

/// A mesh that cannot be subdivided. The message names the element; the file is not known here.
class SubdivisionError : public UserError {
 public:
  using UserError::UserError;
};

/// How an old interior vertex of valence n moves in Loop's scheme:
/// (1 - n b) v + b (sum of its neighbours).
enum class VertexRule {
  kLoop,    ///< b = (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n  (Loop 1987; OpenSubdiv)
  kWarren,  ///< b = 3/16 for n = 3, otherwise 3 / (8 n)      (Warren; taught at Berkeley)
};

/// What becomes of a boundary vertex that lies on one face only.
enum class CornerRule {
  kSmooth,  ///< 3/4, 1/8, 1/8 as on the rest of the boundary
  kCorner,  ///< it stays where it is
};

struct SubdivisionOptions {
  VertexRule vertex_rule = VertexRule::kLoop;  ///< Catmull-Clark has one rule only
  CornerRule corner_rule = CornerRule::kSmooth;
  unsigned levels = 1;
  /// The result is the same to the last bit for every number of threads.
  unsigned threads = 1;
  /// Called now and then, in the calling thread, with the part that is done: 0 to 1.
  std::function<void(double)> progress;
};

}  // namespace meshgrade
