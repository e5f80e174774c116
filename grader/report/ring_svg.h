#pragma once

#include "grader/judge/finding.h"
#include "grader/report/svg_pen.h"

namespace meshgrade {

/// Draws the faces around an operation's element, before, yours and expected side by side. The
/// rim is a circle, the same in all three; what is inside lies in the middle of its neighbours
/// (Tutte 1963), and not where it is in space, since new vertices often lie on old ones.
/// @return the width and height that it takes, from (0, 0)
Spot draw_ring(const SvgPen& pen, const Finding& finding);

}  // namespace meshgrade
