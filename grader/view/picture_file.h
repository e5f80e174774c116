#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "grader/view/picture_request.h"

namespace meshgrade {

/// A picture that can be drawn in two ways; each is called when it is needed.
struct Drawing {
  std::function<std::string()> page;  ///< for a browser to draw
  std::function<std::string()> svg;   ///< by the grader itself
};

/// What was written, and how.
struct WrittenPicture {
  std::filesystem::path file;
  std::string how;

  std::string text() const { return file.string() + ": " + how; }
};

/// Writes a .png by a browser, or an .svg. Where no browser works, an .svg beside the .png that
/// was asked for.
/// @throws UserError if the file cannot be written
WrittenPicture write_picture(const std::filesystem::path& out, const Drawing& drawing,
                             const PictureRequest& request);

}  // namespace meshgrade
