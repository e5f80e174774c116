#include "grader/report/svg_figure.h"

#include <cmath>
#include <sstream>

#include "grader/base/text.h"
#include "grader/report/figure_text.h"
#include "grader/report/neighbourhood_svg.h"
#include "grader/report/surface_svg.h"

namespace meshgrade {
namespace {

constexpr double kHeadHeight = 34.0;

std::string description(const CaseReport& report, const Finding& finding) {
  std::string text = report.title + "\n";
  if (!finding.where.empty()) text += finding.where + "\n";
  text += finding.rule + ": " + finding.meaning + "\nat: " + finding.element +
          "\nexpected: " + finding.expected + "\nyours: " + finding.actual + "\n";
  return printable(text + (finding.surface.empty() ? figure_text(finding.pointers.figure)
                                                   : figure_text(finding.surface)));
}

void append_text(pugi::xml_node svg, const char* element, const std::string& id,
                 const std::string& text) {
  pugi::xml_node node = svg.append_child(element);
  node.append_attribute("id").set_value(id.c_str());
  node.text().set(text.c_str());
}

/// Of the root, once its size is known.
void set_size(pugi::xml_node svg, Spot size) {
  const std::string width = std::to_string(std::lround(size.x));
  const std::string height = std::to_string(std::lround(size.y));
  svg.append_attribute("width").set_value(width.c_str());
  svg.append_attribute("height").set_value(height.c_str());
  svg.append_attribute("viewBox").set_value(("0 0 " + width + " " + height).c_str());
}

void draw(pugi::xml_node svg, const CaseReport& report, const Finding& finding) {
  const SvgPen pen(svg);
  pugi::xml_node ground = svg.append_child("rect");
  const SvgPen content = pen.moved_group("content", {0.0, kHeadHeight});
  Spot size = finding.surface.empty() ? draw_neighbourhood(content, finding)
                                      : draw_surface(content, finding.surface);
  size.y += kHeadHeight;
  const std::string where = finding.where.empty() ? "" : ", " + finding.where;
  const auto letters = static_cast<std::size_t>(size.x / text_width("m", 15.0));
  pen.text({14.0, 22.0}, shortened(printable(report.id + ": " + report.title + where), letters),
           {15.0, ink::kText, false, Anchor::kStart, false});
  ground.append_attribute("class").set_value("ground");
  ground.append_attribute("width").set_value(std::to_string(std::lround(size.x)).c_str());
  ground.append_attribute("height").set_value(std::to_string(std::lround(size.y)).c_str());
  ground.append_attribute("fill").set_value(ink::kPaper);
  set_size(svg, size);
}

}  // namespace

const Finding* pictured_finding(const CaseReport& report) {
  for (const FindingReport& found : report.findings) {
    const Finding& finding = found.finding;
    if (!finding.pointers.figure.empty() || !finding.surface.empty()) return &finding;
  }
  return nullptr;
}

std::string to_svg(const CaseReport& report, const std::string& id) {
  const Finding* finding = pictured_finding(report);
  if (finding == nullptr) return {};
  pugi::xml_document document;
  pugi::xml_node svg = document.append_child("svg");
  svg.append_attribute("xmlns").set_value("http://www.w3.org/2000/svg");
  svg.append_attribute("class").set_value("meshgrade-figure");
  svg.append_attribute("role").set_value("img");
  svg.append_attribute("font-family").set_value("DejaVu Sans Mono, Menlo, Consolas, monospace");
  svg.append_attribute("aria-labelledby").set_value((id + "-title " + id + "-desc").c_str());
  append_text(svg, "title", id + "-title",
              printable(report.id + ": " + report.title + ": " + verdict_name(report.verdict)));
  append_text(svg, "desc", id + "-desc", description(report, *finding));
  draw(svg, report, *finding);
  std::ostringstream text;
  document.save(text, "", pugi::format_raw | pugi::format_no_declaration);
  return text.str() + "\n";
}

}  // namespace meshgrade
