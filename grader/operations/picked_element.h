#pragma once

#include <cstdint>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"
#include "grader/operations/local_operation.h"

namespace meshgrade {

/// The mesh that build() makes, each element with the next anchor around it so many times.
/// @throws meshedit::MeshError if the polygons are no surface
MeshDump built_mesh(const PolygonMesh& mesh, std::uint32_t anchor_turns = 0);

/// How many live elements of a kind there are; of faces, those of the surface.
std::uint32_t count_elements(const MeshDump& mesh, ElementKind kind);

/// The live element of a kind with this place among them, counted on from the beginning if
/// there are fewer; kUnsetRef if there is none.
Ref find_element(const MeshDump& mesh, ElementKind kind, std::uint32_t place);

/// An element by its corners. The mesh keeps all rules.
Picked corners_of(const MeshDump& mesh, ElementKind kind, Ref element);

/// Both at once, of an element that is there.
Picked pick(const MeshDump& mesh, ElementKind kind, std::uint32_t place);

}  // namespace meshgrade
