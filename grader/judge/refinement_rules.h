#pragma once

// Where the vertices of the next level lie by linear and by Catmull-Clark subdivision, in
// closed form, and where they would lie by what is often mistaken for it.

#include <string>
#include <vector>

#include "grader/judge/misconception.h"
#include "grader/judge/surface_rings.h"
#include "grader/mesh/refined_mesh.h"

namespace meshgrade {

enum class RefinementScheme { kLinear, kCatmullClark };

/// Points of the next level by what they belong to: each kind is computed from those before.
enum class PointKind { kFace, kEdge, kVertex };

inline const std::vector<Point3>& points_of(const RefinedPoints& points, PointKind kind) {
  if (kind == PointKind::kFace) return points.faces;
  return kind == PointKind::kEdge ? points.edges : points.vertices;
}

/// One level's rules on one mesh. Catmull and Clark's edges and vertices are computed from face
/// points, which are given: so it can be told whether what is wrong follows from wrong ones.
class RefinementRules {
 public:
  /// @param given  one point for each face and edge
  RefinementRules(const SurfaceRings& rings, RefinementScheme scheme,
                  const RefinedPoints& given)
      : rings_(rings), scheme_(scheme), given_(given) {}

  /// The points of one kind: face points from the corners, the others from what is given.
  std::vector<Point3> points(PointKind kind) const;

  /// The points that each known misconception gives, by its name.
  std::vector<Prediction<Point3>> predictions(PointKind kind) const;

 private:
  const SurfaceRings& rings_;
  RefinementScheme scheme_;
  const RefinedPoints& given_;
};

/// All that the predictions can name.
const Misconceptions& refinement_misconceptions(RefinementScheme scheme);

}  // namespace meshgrade
