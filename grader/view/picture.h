#pragma once

// Pictures of a session, for write-ups.

#include <string>
#include <vector>

#include "grader/view/bezier_view.h"
#include "grader/view/mesh_session.h"
#include "grader/view/picture_request.h"

namespace meshgrade {

/// What the picture shows, in a line: "cube.obj: flip e3, subdivide; 26 vertices, ...".
std::string picture_title(const MeshSession& session);

/// The viewer's page, filled such that it shows nothing but the picture.
/// @param page  the page without data
/// @throws GraderError if this is not the viewer's page
/// @param normals  of the last state by its vertices' numbers; empty: none
std::string picture_page(const MeshSession& session, const PictureRequest& request,
                         const std::vector<Point3>& normals, const std::string& page);

/// The picture as the grader draws it without a browser.
std::string picture_svg(const MeshSession& session, const PictureRequest& request,
                        const std::vector<Point3>& normals);

/// A page with nothing but an SVG picture of that size.
std::string svg_page(const std::string& svg);

/// The surface that the student's evaluate gave: a mesh of quads that is only good to be drawn.
MeshDump drawn_surface(const PatchLook& look);

/// The same as a picture, +z up.
std::string patch_svg(const PatchLook& look, const PictureRequest& request,
                      const std::string& title);

}  // namespace meshgrade
