#pragma once

// What a picture of `meshgrade view --screenshot` is to show, as it stands on the command line.

#include <string>
#include <vector>

#include "grader/view/view_verbs.h"

namespace meshgrade {

/// Where the eye is. Angles in degrees: azimuth 0 looks from +z, 90 from +x; elevation 90 looks
/// from above (+y). The distance is in halves of the diagonal of the mesh's bounding box.
struct Camera {
  double azimuth = 31.0;
  double elevation = 22.0;
  double distance = 3.5;
};

/// In pixels.
struct PictureSize {
  int width = 960;
  int height = 720;
};

struct PictureRequest {
  std::vector<ViewOperation> steps;
  Camera camera;
  PictureSize size;
  bool wireframe = false;
  bool ids = false;
  bool dark = false;
  bool levels = false;   ///< level 0, 1, ... side by side, not the last one alone
  bool smooth = false;   ///< shade by the student's vertex normals, without edges
  bool normals = false;  ///< draw the student's vertex normals as lines
  bool z_up = false;     ///< +z is up and azimuth 0 looks from -y, as surfaces are modelled
  bool compare = false;  ///< colour vertices by their distance from OpenSubdiv's answer
};

/// "flip e3, weld e5 e9, subdivide 2": steps with commas between them, at most kMostSteps.
/// @throws UserError that names the step that cannot be read
std::vector<ViewOperation> parse_steps(const std::string& text,
                                       const std::vector<ViewVerb>& verbs);

/// "azimuth,elevation[,distance]"
/// @throws UserError if these are not two or three numbers in their bounds
Camera parse_camera(const std::string& text);

/// "960x720"
/// @throws UserError if it is no size from 64x64 to 4096x4096
PictureSize parse_size(const std::string& text);

constexpr std::size_t kMostSteps = 200;
constexpr std::size_t kMostSubdivisions = 7;

}  // namespace meshgrade
