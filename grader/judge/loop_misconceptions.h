#pragma once

// What a wrong Loop subdivision probably comes from.

#include <cstdint>
#include <vector>

#include "grader/judge/misconception.h"
#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// Where a vertex of a refined mesh comes from.
struct Origin {
  std::uint32_t a = 0;  ///< the old vertex, or one end of the old edge
  std::uint32_t b = 0;  ///< the other end; the same as `a` for an old vertex

  bool is_old() const { return a == b; }
};

/// Misconceptions about positions that explain all of `actual`.
///
/// @param old       the mesh before the step
/// @param origins   for each refined vertex
/// @param variants  the right positions, by every rule that is allowed
/// @param others    positions by published rules that are not allowed here, each named
/// @param actual    the student's positions, in the same order
/// @param allowed   a length
std::vector<Misconception> recognize_positions(const PolygonMesh& old,
                                               const std::vector<Origin>& origins,
                                               const std::vector<std::vector<Point3>>& variants,
                                               const std::vector<Prediction<Point3>>& others,
                                               const std::vector<Point3>& actual,
                                               double allowed);

/// Misconceptions about which edges are split and flipped that give the surface `actual`.
/// `before` keeps all mesh rules; `actual` keeps all but perhaps `simple`.
std::vector<Misconception> recognize_connectivity(const MeshDump& before,
                                                  const MeshDump& actual);

}  // namespace meshgrade
