#pragma once

#include "grader/files/collada_document.h"
#include "grader/files/reading_notes.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// The polygons of an element geometry, untransformed: of its mesh or convex_mesh, as
/// triangles, tristrips, trifans, polylist or polygons. Lines, splines and convex hulls of
/// other geometries are counted in `notes`. Throws UserError with the line.
PolygonMesh collada_geometry(const ColladaDocument& document, const pugi::xml_node& geometry,
                             ReadingNotes& notes);

}  // namespace meshgrade
