#pragma once

// What a wrong Loop subdivision probably comes from.

#include <cstdint>
#include <string>
#include <vector>

#include "grader/judge/misconception.h"
#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"
#include "grader/subdivide/loop_rules.h"

namespace meshgrade {

/// Where a vertex of a refined mesh comes from.
struct Origin {
  std::uint32_t a = 0;  ///< the old vertex, or one end of the old edge
  std::uint32_t b = 0;  ///< the other end; the same as `a` for an old vertex

  bool is_old() const { return a == b; }
};

/// The right positions by one of the published rules.
struct RightPositions {
  VertexRule rule;
  std::vector<Point3> points;
};

/// Positions by a published rule that is not allowed here, and what to say to who takes it.
struct OtherRule {
  std::string
      name;  ///< of the misconception; "rules-mixed" if only the cases before rule it out
  std::string advice;
  RightPositions positions;
};

/// One step of subdivision as the judge has it. Lists of points are in the order of `origins`.
struct RefinedStep {
  const PolygonMesh& old;              ///< the mesh before the step
  const std::vector<Origin>& origins;  ///< of each refined vertex
  std::vector<RightPositions> right;   ///< by every rule that is allowed
  std::vector<OtherRule> others;       ///< by every rule that is not
};

/// All about Loop subdivision; those of them about positions, and about which edges are
/// flipped.
const Misconceptions& loop_misconceptions();
const Misconceptions& position_misconceptions();
const Misconceptions& flip_misconceptions();

/// Misconceptions about positions that explain all of `actual`, to `allowed`, a length.
Misconceptions recognize_positions(const RefinedStep& step, const std::vector<Point3>& actual,
                                   double allowed);

/// Misconceptions about which edges are split that make `actual` elements out of those of the
/// mesh before the step.
Misconceptions recognize_counts(const PolygonMesh& old, const Counts& before,
                                const Counts& actual);

/// Misconceptions about which edges are split and flipped that give the surface `actual`.
///
/// @param before        keeps all mesh rules
/// @param actual        may break them, but all its pointers lead to live elements
/// @param first_marked  vertices from this number on were new in a level before
Misconceptions recognize_connectivity(const MeshDump& before, const MeshDump& actual,
                                      Ref first_marked);

}  // namespace meshgrade
