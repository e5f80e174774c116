#pragma once

// Pictures in words, for readers who cannot see them.

#include <string>

#include "grader/judge/neighbourhood_figure.h"
#include "grader/judge/ring_figure.h"
#include "grader/judge/surface_figure.h"

namespace meshgrade {

/// "h12 (mc): next h5 (ca), twin h7 (cm), vertex v4 (m), edge e2, face f1 (mca)"
std::string element_text(const FigurePanel& panel, ElementKind kind, std::size_t place);

/// "not created: half-edges mc, cm; edge mc"; empty if nothing is missing.
std::string missing_text(const NeighbourhoodFigure& figure);

/// What the marked vertices have in common: "in a wrong place".
std::string fault_text(const SurfaceFigure& figure);

/// All that the picture shows.
std::string figure_text(const NeighbourhoodFigure& figure);
std::string figure_text(const SurfaceFigure& figure);
std::string figure_text(const RingFigure& figure);

}  // namespace meshgrade
