#pragma once

// Whether a mesh is what the cheapest collapses leave, in whatever order ties were broken.

#include <optional>
#include <string>
#include <vector>

#include "grader/judge/quadric_collapses.h"
#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// One collapse that was done or must be.
struct DoneCollapse {
  LabelPair edge;
  EdgeCost cost;
};

/// The vertices of a mesh that was left: for each label of a vertex that is not where it was,
/// or is another one, the record in the dump.
using MergedRefs = std::map<Label, Ref>;

/// @return nothing unless the dump has just these faces, and all other vertices in their places
std::optional<MergedRefs> match_collapsed(const CollapsingMesh& mesh, const MeshDump& after);

enum class Fit {
  kFits,
  kUnknown,  ///< a right solution may have left it: choices that are free make it hard to say
  kOtherPoints,  ///< the right edges have gone, and a vertex lies elsewhere
  kNone,
};

/// Whether a right solution may have left a mesh.
struct CollapseFit {
  Fit fit = Fit::kNone;
  /// Of kOtherPoints: the vertex that is off, where it should be, and what it costs there and
  /// where it is.
  Ref vertex = kUnsetRef;
  Point3 at{};
  double cost = 0.0;
  double actual_cost = 0.0;
};

/// An edge may be collapsed at any time if it costs no more than the cheapest one that must be
/// collapsed. Need not be collapsed: what leaves two edges between the same vertices, what
/// turns a face over (programs that look at this are right, too), and where the mesh has a
/// boundary, edges that touch it, since planes across the boundary may be added, which only
/// make these dearer.
/// @param n  how many collapses were done; more than one only of closed meshes
CollapseFit fit_collapses(const FaceLists& before, const CollapseWay& way, std::size_t n,
                          const MeshDump& after);

/// The collapses of a way that takes the cheapest edge each time.
struct CollapsePath {
  std::vector<DoneCollapse> done;
  CollapsingMesh left;
};
CollapsePath cheapest_collapses(const FaceLists& before, const CollapseWay& way, std::size_t n);

/// Whether the dump is what this path leaves, with all vertices in its places.
bool is_left_by(const CollapsePath& path, const MeshDump& after, double allowed);

}  // namespace meshgrade
