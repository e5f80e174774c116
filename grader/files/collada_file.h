#pragma once

#include <filesystem>
#include <string>

#include "grader/files/mesh_file.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// The polygons of a COLLADA file: those of every geometry that its scene puts in (the first
/// scene if the file names none, all geometries if there is none), with the transforms of the
/// nodes, turned so that y points up. The unit of length is left alone. What is left out stands
/// in the notes. Throws UserError "<file>:<line>: ..." for what is broken or not read (skins
/// and morphs, polygons with holes).
LoadedMesh parse_collada(const std::filesystem::path& file, const std::string& bytes);

/// One geometry as a polylist, in double precision, y up.
std::string format_collada(const PolygonMesh& mesh);

}  // namespace meshgrade
