#pragma once

#include <filesystem>
#include <string>

#include "grader/view/mesh_session.h"
#include "grader/view/picture_request.h"

namespace meshgrade {

/// The options of `meshgrade view --screenshot` as they were written.
struct ScreenshotOptions {
  std::string out;  ///< empty: no picture is asked for
  std::string steps;
  std::string camera;
  std::string size;
  bool wireframe = false;
  bool ids = false;
  bool dark = false;
  bool levels = false;
  bool compare = false;
};

/// What the options ask for.
/// @throws UserError if one of them cannot be read, if the file is neither .png nor .svg, or if
///         it could not be written anyway
PictureRequest read_request(const ScreenshotOptions& options);

/// Runs the steps of the request in a session that is built, and writes the picture. Says on
/// stdout what was drawn, how, and what the judge says of each step.
///
/// A .png is taken by a browser. Where none works, the grader draws an SVG beside it instead.
/// @return 0, or 1 if a step did not come to its end: the picture shows the mesh before it
/// @throws UserError if a step names an edge that is not there, or the file cannot be written
int take_screenshot(MeshSession& session, const PictureRequest& request,
                    const std::filesystem::path& out);

}  // namespace meshgrade
