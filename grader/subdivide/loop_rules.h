#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "grader/base/errors.h"

namespace meshgrade {

/// A mesh that cannot be subdivided. The message names the element; the file is not known here.
class LoopError : public UserError {
 public:
  using UserError::UserError;
};

/// How an old interior vertex of valence n moves: (1 - n b) v + b (sum of its neighbours).
enum class VertexRule {
  kLoop,    ///< b = (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n  (Loop 1987; OpenSubdiv)
  kWarren,  ///< b = 3/16 for n = 3, otherwise 3 / (8 n)      (Warren; taught at Berkeley)
};

/// What becomes of a boundary vertex that lies on one face only.
enum class CornerRule {
  kSmooth,  ///< 3/4, 1/8, 1/8 as on the rest of the boundary
  kCorner,  ///< it stays where it is
};

/// The weight b of each neighbour of an interior vertex of `valence` >= 3.
inline double neighbour_weight(VertexRule rule, std::size_t valence) {
  const double n = static_cast<double>(valence);
  if (rule == VertexRule::kWarren) return valence == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * n);
  const double c = 3.0 / 8.0 + std::cos(2.0 * std::numbers::pi / n) / 4.0;
  return (5.0 / 8.0 - c * c) / n;
}

}  // namespace meshgrade
