#pragma once

// What a write-up asks for: docs/writeup_rubric.toml, or a course's own file of that form.

#include <filesystem>
#include <string>
#include <vector>

#include "grader/cases/view_input.h"
#include "grader/mesh/bezier_data.h"
#include "grader/view/picture_request.h"

namespace meshgrade {

enum class PictureKind { kCurve, kPatch, kMesh };

/// A picture by the student's own functions.
struct PicturePlan {
  PictureKind kind = PictureKind::kMesh;
  std::string name;     ///< of its file, without an extension
  std::string caption;  ///< what is seen
  std::string place;    ///< "writeup_rubric.toml:42", for messages
  std::filesystem::path file;
  std::vector<Point2> points;     ///< of a curve
  std::vector<ControlNet> nets;   ///< of a surface
  PolygonMesh mesh;               ///< of a mesh
  double t = 0.5;                 ///< of a curve
  std::size_t levels_shown = 40;  ///< of a curve: how many levels of de Casteljau's algorithm
  int density = 8;                ///< of a surface
  PictureRequest request;
};

/// An item of the rubric.
struct RubricPart {
  std::string heading;
  std::string asks;  ///< what the student is to write
  std::vector<PicturePlan> pictures;
};

struct WriteupRubric {
  std::string title;
  std::vector<RubricPart> parts;
};

/// Reads a rubric and the meshes, curves and surfaces that it names: from beside it, or else
/// from `meshes`. A curve that is to be shown level by level becomes a picture for each.
/// @param verbs  what steps may be; those of meshes of triangles if not given
/// @throws UserError that names the file, the line and the key
WriteupRubric read_rubric(const std::filesystem::path& file,
                          const std::filesystem::path& meshes,
                          const std::vector<ViewVerb>& verbs = view_verbs({}));

}  // namespace meshgrade
