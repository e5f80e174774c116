#pragma once

#include <filesystem>
#include <string>

#include "grader/files/mesh_file.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// The triangles of the default scene of a glTF 2.0 file, text or binary, with the transforms
/// of its nodes, its skins in the pose of the joints and its morphs by their weights. Corners
/// are as split as in the file: weld them. Quantised and meshopt-compressed data are read.
/// Buffers may be embedded or be files in the same folder or below it. What is left out, such
/// as lines and points, stands in the notes. Throws UserError with the place, e.g.
/// "meshes[0].primitives[1]", for anything else.
LoadedMesh parse_gltf(const std::filesystem::path& file, const std::string& bytes);

/// One mesh of triangles in single precision: a .glb, or a .gltf with its buffer inside.
std::string format_gltf(const PolygonMesh& mesh, bool as_binary);

}  // namespace meshgrade
