#pragma once

#include <filesystem>
#include <string>

#include "grader/view/bezier_view.h"
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
  bool smooth = false;
  bool normals = false;
  double t = 0.5;         ///< of a curve
  int levels_shown = -1;  ///< of de Casteljau's algorithm; below 0: all
  int density = 16;       ///< of a surface
};

/// What the options ask for.
/// @param verbs  what the steps may be
/// @throws UserError if one of them cannot be read, if the file is neither .png nor .svg, or if
///         it could not be written anyway
PictureRequest read_request(const ScreenshotOptions& options,
                            const std::vector<ViewVerb>& verbs);

/// Pictures of curves and surfaces by a program that is built, as take_screenshot.
/// @return 0, or 1 if the judge finds something wrong
int take_curve(const StudentProgram& program, const std::vector<Point2>& points,
               const ScreenshotOptions& options, const std::string& name);
int take_surface(const StudentProgram& program, const std::vector<ControlNet>& nets,
                 const ScreenshotOptions& options, const std::string& name);

/// Runs the steps of the request in a session that is built, and writes the picture. Says on
/// stdout what was drawn, how, and what the judge says of each step.
///
/// A .png is taken by a browser. Where none works, the grader draws an SVG beside it instead.
/// @return 0, or 1 if a step did not come to its end: the picture shows the mesh before it
/// @throws UserError if a step names an element that is not there, or the file cannot be
/// written
int take_screenshot(MeshSession& session, const PictureRequest& request,
                    const std::filesystem::path& out);

}  // namespace meshgrade
