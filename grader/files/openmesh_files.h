#pragma once

#include <string>

#include "grader/files/checked_input.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// Reads a checked file by OpenMesh's reader for `format` ("obj", "off", "ply", "stl") as a bag
/// of polygons: no half-edge mesh is built, so faces that are not manifold arrive, too.
/// Throws GraderError if OpenMesh reads anything else than the check saw.
PolygonMesh openmesh_read(const std::string& format, const CheckedInput& input);

/// Writes by OpenMesh's writer, in single precision with enough digits to read the same floats
/// again: OBJ and OFF as text, PLY and STL in binary. The mesh must have been checked to be
/// finite in single precision, and to be of triangles for STL.
/// Throws GraderError if OpenMesh fails.
std::string openmesh_write(const std::string& format, const PolygonMesh& mesh);

}  // namespace meshgrade
