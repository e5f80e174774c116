#pragma once

#include "grader/judge/surface_figure.h"
#include "grader/report/svg_pen.h"

namespace meshgrade {

/// Draws a subdivided mesh, seen so that its worst vertex is in front, with every wrong vertex
/// marked; beside it the right one from the same side; and below them the list of what is
/// wrong.
/// @return the width and height that it takes, from (0, 0)
Spot draw_surface(const SvgPen& pen, const SurfaceFigure& figure);

}  // namespace meshgrade
