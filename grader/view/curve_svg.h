#pragma once

#include <string>

#include "grader/view/bezier_view.h"
#include "grader/view/picture_request.h"

namespace meshgrade {

/// Draws a curve with its control polygon, the exact curve behind it, and the first so many
/// levels of de Casteljau's algorithm. What the code did not come to is not drawn.
/// @param levels  how many; more than there are: all
/// @param title   what the picture is of, for those who do not see it
std::string curve_svg(const CurveLook& look, std::size_t levels, const PictureRequest& request,
                      const std::string& title);

}  // namespace meshgrade
