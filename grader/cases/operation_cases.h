#pragma once

#include <string>
#include <vector>

#include "grader/cases/case_list.h"
#include "grader/cases/mesh_input.h"
#include "grader/cases/mesh_shapes.h"

namespace meshgrade {

/// "v0-v4"
std::string edge_text(VertexPair edge);

/// "flip", "split"
const char* verb(OperationKind kind);

/// Adds a case of these operations, with a step budget in proportion to the mesh.
void add_operations(CaseMaker& maker, const std::string& group, const std::string& title,
                    const OperationsInput& input);

enum class EdgeChoice { kInner, kBoundary };

/// Adds two cases for every boundary edge of a mesh file, or for every inner one: with the
/// anchors as they are built, and with the others. At the boundary, those have the half-edge
/// outside as the edge's own.
void add_every_edge(CaseMaker& maker, const std::string& group, OperationKind kind,
                    const std::string& file, EdgeChoice choice);

/// Adds a case for each of these edges, with all elements of the mesh anchored elsewhere than
/// as they are built.
void add_every_edge_elsewhere(CaseMaker& maker, const std::string& group, OperationKind kind,
                              const std::string& file, EdgeChoice choice);

/// Adds a random sequence of `length` splits, two of three of them at the boundary: so that
/// parts of an edge that was split are split again.
void add_split_sequence(CaseMaker& maker, const std::string& group, const std::string& file,
                        std::uint32_t length, Random& random);

/// Adds such sequences on open meshes: under each map of moved_meshes(), with 22 triangles
/// around a vertex, on a mesh of 512 triangles, and in processes in which nothing was called
/// before. The elements around their edges are anchored in all ways of anchor_on().
void add_more_boundary_splits(CaseMaker& maker, const std::string& group, Random& random);

/// Adds a random sequence of `length` operations on inner edges of a mesh file. Each is one
/// that has a single right outcome: flips never double an edge. `flips_of_ten` says how many
/// of ten operations are flips.
void add_sequence(CaseMaker& maker, const std::string& group, const std::string& file,
                  std::uint32_t length, std::uint32_t flips_of_ten, Random& random);

/// Adds sequences of operations of one kind, one for each way of anchor_on(), on a mesh that is
/// drawn from these files and shaken, under each map of moved_meshes().
void add_moved_sequences(CaseMaker& maker, const std::string& group, OperationKind kind,
                         const std::vector<std::string>& files, Random& random);

/// Adds two operations of this kind at a vertex of each valence from 13 to 24. The half-edges
/// of their edges start at that vertex.
void add_high_valences(CaseMaker& maker, const std::string& group, OperationKind kind,
                       Random& random);

/// Adds what is one operation on a torus of 2 n n triangles, with a budget that allows no walk
/// over the mesh.
void add_constant_work(CaseMaker& maker, const std::string& group, OperationKind kind,
                       std::uint32_t n);

/// Adds an operation for each way of anchor_on() on a closed mesh of 1152 triangles; and
/// sequences of `length` on a mesh file, each in a process in which nothing was called before,
/// so that the third call, say, meets each way to anchor.
void add_large_sequence(CaseMaker& maker, const std::string& group, OperationKind kind,
                        Random& random);
void add_fresh_sequences(CaseMaker& maker, const std::string& group, OperationKind kind,
                         const std::string& file, std::uint32_t length, Random& random);

}  // namespace meshgrade
