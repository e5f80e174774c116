#pragma once

// Whether a flip or a split has made the surface that it should, whatever the numbering; and
// what is another one, if not. All meshes must keep all mesh rules.

#include <optional>
#include <string>

#include "grader/judge/finding.h"
#include "grader/judge/surface_match.h"
#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// A flipped or split mesh, and what it should be.
struct OperationResult {
  const MeshDump& before;
  const MeshDump& after;
  const MeshDump& expected;
  Ref free_edge = kUnsetRef;  ///< the edge that a split makes two of: it may be either of them
};

/// "v0-v3"
std::string edge_ends(const MeshDump& mesh, Ref edge);

/// From the expected mesh to the student's: old vertices and old edges by their identity,
/// half-edges and faces in any way. Nothing if they are not the same surface.
std::optional<SurfaceMatch> match_operation(const OperationResult& result);

/// Says how the surfaces differ: other faces, faces that are turned, or old edges that have
/// changed places.
/// @param where, edge  for the finding: which operation, and the edge that it is about
Finding surface_finding(const OperationResult& result, const std::string& where, Ref edge);

}  // namespace meshgrade
