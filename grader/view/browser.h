#pragma once

#include <filesystem>
#include <string>

#include "grader/view/picture_request.h"

namespace meshgrade {

/// The first of chromium, chromium-browser, google-chrome and google-chrome-stable that is on
/// the PATH; empty if there is none.
std::filesystem::path find_browser();

/// What a browser made of a page.
struct Photograph {
  std::string png;  ///< the bytes of the picture; empty if there is none
  std::string why;  ///< there is none
};

/// Opens a page that draws itself while it is loaded, without a display, and takes a picture of
/// it. Profile, page and picture lie in a temporary folder that is gone afterwards.
/// @throws GraderError if the browser cannot be started at all
Photograph photograph(const std::filesystem::path& browser, const std::string& page,
                      PictureSize size, bool dark);

}  // namespace meshgrade
