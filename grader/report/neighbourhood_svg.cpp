#include "grader/report/neighbourhood_svg.h"

#include <algorithm>

#include "grader/base/text.h"
#include "grader/report/figure_text.h"
#include "grader/report/list_column.h"
#include "grader/report/panel_artist.h"

namespace meshgrade {
namespace {

constexpr double kMargin = 14.0;
constexpr double kTitleHeight = 28.0;
constexpr std::size_t kMostListedPointers = 12;

struct PanelTitle {
  PanelPart part;
  const char* css_class;
  std::string title;
  const char* color;
};

std::vector<PanelTitle> panel_titles(const NeighbourhoodFigure& figure) {
  const std::size_t faults = figure.faults.size();
  const bool created = missing_text(figure).empty();
  const bool complete = created && figure.deleted.empty();
  return {{PanelPart::kBefore, "panel before", "before", ink::kText},
          {PanelPart::kYours, "panel yours",
           figure.is_stopped         ? "yours, when it was stopped"
           : !created                ? "yours: not all is created"
           : !figure.deleted.empty() ? "yours: old elements are deleted"
           : faults == 0             ? "yours"
                                     : "yours: " + plural(faults, "wrong pointer"),
           complete && faults == 0 && !figure.is_stopped ? ink::kText : ink::kWrong},
          {PanelPart::kExpected, "panel expected", "expected",
           faults == 0 ? ink::kText : ink::kRight}};
}

void list_faults(ListColumn& column, const NeighbourhoodFigure& figure) {
  bool headed[] = {false, false};
  for (std::size_t i = 0; i < std::min(figure.faults.size(), kMostListedPointers); ++i) {
    const FigureFault& fault = figure.faults[i];
    if (!headed[fault.was_set ? 1 : 0]) {
      column.heading(fault.was_set ? "Set, but wrong:" : "Not changed, but must be:");
      headed[fault.was_set ? 1 : 0] = true;
    }
    column.numbered(i + 1, fault.text);
  }
  if (figure.faults.size() > kMostListedPointers) {
    column.sentence("and " + std::to_string(figure.faults.size() - kMostListedPointers) +
                    " more: the report lists them all");
  }
}

void list_what_is_wrong(ListColumn& column, const Finding& finding) {
  const PointerDiff& diff = finding.pointers;
  if (diff.figure.is_stopped) {
    column.heading("Stopped within the operation: " + finding.actual);
  }
  list_faults(column, diff.figure);
  const std::string missing = missing_text(diff.figure);
  if (!missing.empty()) {
    column.heading((diff.figure.is_stopped ? "Not yet created" : "Not created") +
                   missing.substr(std::string("not created").size()));
  }
  if (!diff.figure.surplus.empty()) {
    column.heading("Created, but not needed: " + join(diff.figure.surplus, ", "));
  }
  if (!diff.figure.deleted.empty()) {
    column.heading("Deleted, but must stay: " + join(diff.figure.deleted, ", "));
  }
  if (diff.figure.faults.empty() && missing.empty() && diff.figure.deleted.empty() &&
      !diff.figure.is_stopped) {
    column.heading(finding.meaning);
    column.sentence("expected: " + finding.expected);
    column.sentence("yours: " + finding.actual);
  }
}

void explain_the_signs(ListColumn& column, const NeighbourhoodFigure& figure) {
  column.gap();
  column.quiet(
      "Each arrow is a half-edge, drawn inside its face; the hook at its tip leads to its "
      "next. "
      "In a dark box: a vertex.");
  if (figure.faults.empty()) return;
  column.quiet(
      "A thick arrow has a wrong pointer. A dashed line shows where that pointer leads; the "
      "line "
      "with the same number on the right, where it must lead.");
  if (figure.faults.size() > kMostDrawnFaults) {
    column.quiet("Dashed lines are drawn for the first " + std::to_string(kMostDrawnFaults) +
                 " only: begin with these.");
  }
}

}  // namespace

Spot draw_neighbourhood(const SvgPen& pen, const Finding& finding) {
  const NeighbourhoodFigure& figure = finding.pointers.figure;
  const Box frame = DiamondLayout(figure.expected).frame();
  const double width = frame.x1 - frame.x0;
  double x = kMargin;
  for (const PanelTitle& title : panel_titles(figure)) {
    const Spot origin{x - frame.x0, kTitleHeight - frame.y0};
    const SvgPen panel = pen.moved_group(title.css_class, origin);
    panel.frame({frame.x0, frame.y0 - kTitleHeight, frame.x1, frame.y1});
    panel.text({0.0, frame.y0 - 0.5 * kTitleHeight}, title.title,
               {16.0, title.color, true, Anchor::kMiddle, false});
    draw_panel(panel, {figure, title.part, finding.element});
    x += width;
  }
  ListColumn column(pen.group("list"), {kMargin, kTitleHeight + frame.y1 - frame.y0 + 6.0},
                    x + kMargin);
  list_what_is_wrong(column, finding);
  explain_the_signs(column, figure);
  return {x + kMargin, column.bottom() + kMargin};
}

}  // namespace meshgrade
