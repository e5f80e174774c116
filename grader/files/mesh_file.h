#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

struct LoadedMesh {
  PolygonMesh mesh;
  /// What was done to the mesh while reading, e.g. "welded 36 corners into 8 vertices" or
  /// "left out 3 lines, the first at line 17".
  std::vector<std::string> notes;
};

/// Reads a mesh. The extension, in any case, tells the format: .obj .off .ply .stl .gltf .glb
/// .dae (see docs/formats.md). STL and glTF, whose faces share no corners, are welded.
///
/// Every polygon arrives, also where the surface is not a manifold, but those without area
/// that have a corner twice. Those, vertices of no face and whatever else is left out stand in
/// the notes with their number. What is promised: at least one polygon; each has at least 3
/// corners, all different and all existing; every vertex belongs to a polygon; every coordinate
/// is finite. Throws UserError with one line "<file>:<place>: what is wrong; what to do".
LoadedMesh read_mesh(const std::filesystem::path& file);

/// Writes a mesh in the format that the extension tells. Throws UserError if the format is
/// unknown or cannot hold the mesh, or if the file cannot be written.
void write_mesh(const std::filesystem::path& file, const PolygonMesh& mesh);

/// Throws UserError unless read_mesh and write_mesh know the extension of `file`.
void require_mesh_format(const std::filesystem::path& file);

}  // namespace meshgrade
