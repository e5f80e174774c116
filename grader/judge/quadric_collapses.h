#pragma once

// Simplification by quadric errors, done on lists of triangles: small meshes and few collapses.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grader/judge/quadric_error.h"
#include "grader/operations/face_lists.h"

namespace meshgrade {

using LabelPair = std::pair<Label, Label>;  ///< the ends of an edge, the smaller first

/// What becomes of the edges at the vertex that a collapse has left.
enum class Renewal {
  kNewCosts,  ///< they get new costs
  kOldCosts,  ///< they keep those of the edges that they were
  kOldBest,   ///< and the best points as well
};

/// A way to choose and to place, right or wrong.
struct CollapseWay {
  const char* name;
  Quadric (*of_face)(const Point3& p, const Point3& q, const Point3& r);
  /// Where the vertex goes that is left of an edge p-q.
  Point3 (*place)(const Quadric& edge, const Point3& p, const Point3& q);
  /// The edge with the least comes first. `at`: where its vertex goes.
  double (*rank)(const Quadric& edge, const Point3& p, const Point3& q, const Point3& at);
  Renewal renewal = Renewal::kNewCosts;
  bool shares_count_once = false;  ///< a face at both ends counts once
  bool is_anew = false;            ///< a new vertex has the sum of the faces that it has then
  bool is_moved = true;            ///< else it stays in the middle, whatever `place` says
};

/// Those that are right: the planes of all faces weigh the same, or as much as their areas.
const std::vector<CollapseWay>& right_collapse_ways();
/// Those that a mistake makes.
const std::vector<CollapseWay>& wrong_collapse_ways();

/// What an edge costs. Where there is no single best point, solutions may place the vertex in
/// different ways, which cost something between `least` and `most`.
struct EdgeCost {
  double least = 0.0;
  double most = 0.0;
  Point3 at{};  ///< the best point, or one of those
  bool has_single_point = true;
};

class CollapsingMesh {
 public:
  /// @param mesh  of triangles
  CollapsingMesh(const FaceLists& mesh, const CollapseWay& way);

  std::vector<LabelPair> edges() const;

  /// Whether there is no reason to refuse: what is left is a surface, without two edges
  /// between the same vertices.
  bool is_sound(const LabelPair& edge) const;

  /// Whether a face would turn over if the vertex that is left of an edge went there.
  bool turns_a_face(const LabelPair& edge, const Point3& at) const;

  bool is_boundary(Label vertex) const { return surface_.is_boundary(vertex); }

  EdgeCost cost(const LabelPair& edge) const;
  /// By the way's own rank; `at` is where it places the vertex.
  double rank(const LabelPair& edge, Point3& at) const;

  /// What arithmetic in float may be off by in a cost of this edge.
  double rounding(const LabelPair& edge) const;

  /// The mesh after a collapse. The vertex that is left has the label of the smaller end.
  CollapsingMesh collapsed(const LabelPair& edge, const Point3& at) const;

  const FaceLists& lists() const { return lists_; }
  /// Vertices that were made of several, with these.
  const std::map<Label, std::vector<Label>>& merged_vertices() const { return members_; }
  double quadric_at(Label vertex, const Point3& at) const {
    return quadrics_.at(vertex).at(at);
  }

 private:
  Quadric quadric_of(const LabelPair& edge) const;

  FaceLists lists_;
  const CollapseWay* way_;
  Surface surface_;
  std::map<Label, Quadric> quadrics_;
  std::map<Label, std::vector<Label>> members_;
};

}  // namespace meshgrade
