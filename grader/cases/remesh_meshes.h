#pragma once

// Meshes and limits for which it is sure what remeshing does.

#include "grader/cases/mesh_shapes.h"
#include "grader/cases/remesh_input.h"

namespace meshgrade {

/// Which edges are to be too long or too short.
struct WantedEdges {
  bool some_long = false;
  bool some_short = false;
};

struct SureMesh {
  PolygonMesh mesh;
  RemeshSettings settings;
};

/// A mesh, shaken so that there are factors for which it is sure what all splits and collapses
/// of one round lead to; with many of them, where that can be.
/// @throws GraderError if there are none
SureMesh sure_mesh(const PolygonMesh& mesh, WantedEdges wanted, Random& random);

/// A torus with six edges at each vertex, but for so many edges that are flipped, far from each
/// other: only to flip these back pays.
/// @param n  how many squares around and across, 4 for each flipped edge
PolygonMesh torus_with_flips(std::uint32_t n);

/// A torus whose vertices are crowded on one side and on the upper half, with many edges
/// flipped at random.
PolygonMesh crowded_torus(std::uint32_t around, std::uint32_t across, Random& random);

/// A band of triangles between two boundaries that lie close together: its inner edges join
/// them, are short, and cannot be collapsed.
PolygonMesh narrow_band(std::uint32_t n);

}  // namespace meshgrade
