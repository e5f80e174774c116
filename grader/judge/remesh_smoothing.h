#pragma once

// Tangential smoothing in closed form, and what known misconceptions make of it.

#include <array>
#include <cstdint>
#include <vector>

#include "grader/cases/remesh_input.h"
#include "grader/judge/misconception.h"
#include "grader/judge/normals.h"
#include "grader/operations/face_lists.h"

namespace meshgrade {

/// What lies around the vertices of a mesh of triangles, by their labels. Two edges may have
/// the same ends.
struct TriangleRings {
  /// Of each vertex, as often as an edge leads there; none of labels that are not in use.
  std::vector<std::vector<Label>> neighbours;
  std::vector<std::array<Label, 3>> triangles;
  std::vector<bool> on_boundary;

  bool is_closed() const;
};

/// @param mesh    keeps all mesh rules
/// @param labels  of its vertices, by their numbers
/// @param size    labels are less than that
TriangleRings triangle_rings(const MeshDump& mesh, const std::vector<Label>& labels,
                             std::size_t size);

/// Unit normals; of labels that are not in use, and where there is none, not numbers.
/// @param weight  any but kAreaSquared
std::vector<Point3> ring_normals(const TriangleRings& rings, const std::vector<Point3>& at,
                                 NormalWeight weight);

/// Where the vertices lie after so many iterations. Those on a boundary are smoothed like all
/// others. Labels that are not in use stay.
std::vector<Point3> smoothed(const TriangleRings& rings, std::vector<Point3> at, double step,
                             std::uint32_t iterations, NormalWeight weight);

const Misconceptions& smoothing_misconceptions();

/// What each of them makes of it.
/// @param iterations  per round; all rounds begin with the same neighbours
std::vector<Prediction<Point3>> predict_smoothing(const TriangleRings& rings,
                                                  const std::vector<Point3>& at,
                                                  const RemeshSettings& settings);

}  // namespace meshgrade
