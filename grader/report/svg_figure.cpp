#include "grader/report/svg_figure.h"

#include <cmath>

#include "grader/base/text.h"
#include "grader/report/figure_text.h"
#include "grader/report/neighbourhood_svg.h"
#include "grader/report/ring_svg.h"
#include "grader/report/surface_svg.h"

namespace meshgrade {
namespace {

constexpr double kHeadHeight = 34.0;

bool has_picture(const Finding& finding) {
  return !finding.pointers.figure.empty() || !finding.surface.empty() || !finding.ring.empty();
}

std::string words_of_picture(const Finding& finding) {
  if (!finding.surface.empty()) return figure_text(finding.surface);
  if (!finding.ring.empty()) return figure_text(finding.ring);
  return figure_text(finding.pointers.figure);
}

Spot draw_picture(const SvgPen& pen, const Finding& finding) {
  if (!finding.surface.empty()) return draw_surface(pen, finding.surface);
  if (!finding.ring.empty()) return draw_ring(pen, finding);
  return draw_neighbourhood(pen, finding);
}

std::string description(const CaseReport& report, const Finding& finding) {
  std::string text = report.title + "\n";
  if (!finding.where.empty()) text += finding.where + "\n";
  text += finding.rule + ": " + finding.meaning + "\nat: " + finding.element +
          "\nexpected: " + finding.expected + "\nyours: " + finding.actual + "\n";
  return printable(text + words_of_picture(finding));
}

Spot draw(pugi::xml_node svg, const CaseReport& report, const Finding& finding) {
  const SvgPen pen(svg);
  pugi::xml_node ground = svg.append_child("rect");
  const SvgPen content = pen.moved_group("content", {0.0, kHeadHeight});
  Spot size = draw_picture(content, finding);
  size.y += kHeadHeight;
  const std::string where = finding.where.empty() ? "" : ", " + finding.where;
  const auto letters = static_cast<std::size_t>(size.x / text_width("m", 15.0));
  pen.text({14.0, 22.0}, shortened(printable(report.id + ": " + report.title + where), letters),
           {15.0, ink::kText, false, Anchor::kStart, false});
  ground.append_attribute("class").set_value("ground");
  ground.append_attribute("width").set_value(std::to_string(std::lround(size.x)).c_str());
  ground.append_attribute("height").set_value(std::to_string(std::lround(size.y)).c_str());
  ground.append_attribute("fill").set_value(ink::kPaper);
  return size;
}

}  // namespace

const Finding* pictured_finding(const CaseReport& report) {
  for (const FindingReport& found : report.findings) {
    if (has_picture(found.finding)) return &found.finding;
  }
  return nullptr;
}

std::string to_svg(const CaseReport& report, const std::string& id) {
  const Finding* finding = pictured_finding(report);
  if (finding == nullptr) return {};
  return svg_document(
      "meshgrade-figure", id,
      printable(report.id + ": " + report.title + ": " + verdict_name(report.verdict)),
      description(report, *finding),
      [&](pugi::xml_node svg) { return draw(svg, report, *finding); });
}

}  // namespace meshgrade
