#pragma once

// Flip and split on a mesh of plain numbers: one right answer, to compare others with. The mesh
// must keep all mesh rules.

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// The edge between two vertices; kUnsetRef if there is none.
Ref find_edge(const MeshDump& mesh, Ref a, Ref b);

bool is_boundary_edge(const MeshDump& mesh, Ref edge);

/// The corners around an edge, named as in the textbook: b and c are its ends, a lies opposite
/// on the left of its half-edge b -> c, d on the right. On a boundary edge the half-edge inside
/// is taken, and d is unset.
struct Diamond {
  Ref a = kUnsetRef;
  Ref b = kUnsetRef;
  Ref c = kUnsetRef;
  Ref d = kUnsetRef;
};
Diamond diamond_of(const MeshDump& mesh, Ref edge);

/// Anchors an edge and what is around it as anchor_on() of grader/mesh/build_mesh.h does.
void model_anchor_on(MeshDump& mesh, Ref edge, std::uint32_t way = 0);

/// Turns an inner edge between two triangles. Of a mesh that breaks rules it makes what a flip
/// makes that reads all its pointers first and writes them then: all still lead somewhere.
void model_flip(MeshDump& mesh, Ref edge);

/// Splits an edge, inner or boundary, between triangles. @return the new vertex
Ref model_split(MeshDump& mesh, Ref edge);

}  // namespace meshgrade
