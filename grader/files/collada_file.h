#pragma once

#include <filesystem>
#include <string>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// The polygons of a COLLADA file: triangles, polylist and polygons of every geometry that its
/// scene puts in (or of all geometries if there is no scene), with the transforms of the nodes,
/// turned so that y points up. The unit of length is left alone. Throws UserError
/// "<file>:<line>: ..." for what is broken or not read (skins, holes, strips).
PolygonMesh parse_collada(const std::filesystem::path& file, const std::string& bytes);

/// One geometry as a polylist, in double precision, y up.
std::string format_collada(const PolygonMesh& mesh);

}  // namespace meshgrade
