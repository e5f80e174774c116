#pragma once

#include <string>

#include "grader/judge/finding.h"
#include "grader/report/svg_pen.h"

namespace meshgrade {

/// Draws the neighbourhood of a flipped or split edge, before, yours and expected side by side,
/// and below them the list of what is wrong. Wrong pointers are numbered the same in both.
/// @return the width and height that it takes, from (0, 0)
Spot draw_neighbourhood(const SvgPen& pen, const Finding& finding);

}  // namespace meshgrade
