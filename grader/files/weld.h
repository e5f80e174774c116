#pragma once

#include <string>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// Merges vertices whose positions are exactly equal (-0 equals 0), for formats that cannot
/// share corners between faces. The first of equal vertices stays; the order is kept; a vertex
/// that no polygon uses goes. Returns a note such as "welded 36 corners into 8 vertices",
/// empty if nothing was merged.
std::string weld(PolygonMesh& mesh);

/// The words of the note.
std::string weld_note(std::size_t n_corners, std::size_t n_vertices);

}  // namespace meshgrade
