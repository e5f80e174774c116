#pragma once

#include <string>
#include <vector>

#include "meshedit/meshedit.h"

namespace meshedit {

/// The first rule of a half-edge mesh that is broken, in words; empty if all of them hold.
/// Follows no pointer before it is known to lead to a live element of this mesh.
///
/// @param triangles_only  interior faces with other than three corners break a rule as well
std::string broken_rule(const HalfedgeMesh& mesh, bool triangles_only = true);

/// Every pointer between half-edges and to vertices, edges and faces, as numbers. Two meshes of
/// equal wiring differ at most in positions, marks, and in the half-edges that vertices, edges
/// and faces name.
std::vector<std::vector<std::ptrdiff_t>> wiring(const HalfedgeMesh& mesh);

/// `wiring`, and the half-edges that vertices, edges, faces and boundary loops name.
std::vector<std::vector<std::ptrdiff_t>> full_wiring(const HalfedgeMesh& mesh);

/// The number of a vertex in the list of its mesh.
Index number_of(const HalfedgeMesh& mesh, VertexCIter v);

/// The edge between two vertices, by their numbers.
EdgeIter edge_between(HalfedgeMesh& mesh, Index a, Index b);

/// Vertex number i.
VertexIter vertex_at(HalfedgeMesh& mesh, Index i);

}  // namespace meshedit
