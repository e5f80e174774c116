#pragma once

// One panel of the picture of a neighbourhood.

#include <string>

#include "grader/judge/neighbourhood_figure.h"
#include "grader/report/diamond_layout.h"
#include "grader/report/label_boxes.h"
#include "grader/report/svg_pen.h"

namespace meshgrade {

enum class PanelPart { kBefore, kYours, kExpected };

/// At most this many wrong pointers are drawn as arrows of their own; all are told in words.
constexpr std::size_t kMostDrawnFaults = 6;

/// What a panel shows and how it is to be understood.
struct PanelTask {
  const NeighbourhoodFigure& figure;
  PanelPart part = PanelPart::kBefore;
  std::string focus;  ///< the name of an element that is wrong by itself; mostly empty

  const FigurePanel& panel() const {
    return part == PanelPart::kBefore  ? figure.before
           : part == PanelPart::kYours ? figure.yours
                                       : figure.expected;
  }
};

/// Draws the panel around the origin.
void draw_panel(const SvgPen& pen, const PanelTask& task);

}  // namespace meshgrade
