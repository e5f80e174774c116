#pragma once

// Pictures of a session, for write-ups.

#include <string>

#include "grader/view/mesh_session.h"
#include "grader/view/picture_request.h"

namespace meshgrade {

/// What the picture shows, in a line: "cube.obj: flip e3, subdivide; 26 vertices, ...".
std::string picture_title(const MeshSession& session);

/// The viewer's page, filled such that it shows nothing but the picture.
/// @param page  the page without data
/// @throws GraderError if this is not the viewer's page
std::string picture_page(const MeshSession& session, const PictureRequest& request,
                         const std::string& page);

/// The picture as the grader draws it without a browser.
std::string picture_svg(const MeshSession& session, const PictureRequest& request);

}  // namespace meshgrade
