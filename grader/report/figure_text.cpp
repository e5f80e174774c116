#include "grader/report/figure_text.h"

#include "grader/base/text.h"

namespace meshgrade {
namespace {

using Kind = ElementKind;
constexpr Kind kKinds[] = {Kind::kHalfedge, Kind::kVertex, Kind::kEdge, Kind::kFace};
constexpr const char* kNouns[] = {"half-edge", "vertex", "edge", "face"};
constexpr const char* kPlurals[] = {"half-edges", "vertices", "edges", "faces"};

std::string corners_text(const FigureElement& element) {
  if (element.corners.empty()) return element.outside ? " (outside)" : "";
  if (element.corners.find('-') != std::string::npos) return " (outside)";
  return " (" + element.corners + (element.outside ? ", outside)" : ")");
}

std::string name_of(const FigureElement& element) {
  return (element.name.empty() ? "one to be created" : element.name) + corners_text(element);
}

std::string panel_text(const FigurePanel& panel) {
  std::string text;
  for (Kind kind : kKinds) {
    for (std::size_t i = 0; i < panel.of(kind).size(); ++i) {
      text += "  " + std::string(kNouns[static_cast<std::size_t>(kind)]) + " " +
              element_text(panel, kind, i) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string element_text(const FigurePanel& panel, ElementKind kind, std::size_t place) {
  const FigureElement& element = panel.of(kind)[place];
  std::string text = name_of(element);
  if (element.pointers.empty()) return text + ": missing";
  for (std::size_t i = 0; i < element.pointers.size(); ++i) {
    const FigurePointer& pointer = element.pointers[i];
    text += std::string(i == 0 ? ": " : ", ") + pointer_name(kind, i) + " ";
    text += pointer.place == kNotPictured
                ? pointer.text
                : name_of(panel.of(target_kind(kind, i))[pointer.place]);
  }
  return text;
}

std::string missing_text(const NeighbourhoodFigure& figure) {
  std::vector<std::string> parts;
  for (Kind kind : kKinds) {
    std::vector<std::string> missing;
    for (const FigureElement& element : figure.yours.of(kind)) {
      if (element.name.empty()) missing.push_back(element.corners);
    }
    const char* noun =
        (missing.size() == 1 ? kNouns : kPlurals)[static_cast<std::size_t>(kind)];
    if (!missing.empty()) parts.push_back(std::string(noun) + " " + join(missing, ", "));
  }
  return parts.empty() ? "" : "not created: " + join(parts, "; ");
}

std::string figure_text(const NeighbourhoodFigure& figure) {
  std::string wrong;
  for (const FigureFault& fault : figure.faults)
    wrong +=
        std::string(fault.was_set ? "  set, but wrong: " : "  not changed, but must be: ") +
        fault.text + "\n";
  const std::string missing = missing_text(figure);
  if (!missing.empty()) wrong += "  " + missing + "\n";
  if (!figure.surplus.empty())
    wrong += "  created, but not needed: " + join(figure.surplus, ", ") + "\n";
  if (!figure.deleted.empty())
    wrong += "  deleted, but must stay: " + join(figure.deleted, ", ") + "\n";
  return "The triangles around the edge, with the corners a above, b to the left, c to the "
         "right, d below, and m for the new vertex.\n" +
         (wrong.empty() ? "" : "What is wrong:\n" + wrong) + "Before:\n" +
         panel_text(figure.before) +
         (figure.is_stopped ? "Yours, when it was stopped:\n" : "Yours:\n") +
         panel_text(figure.yours) + "Expected:\n" + panel_text(figure.expected);
}

std::string figure_text(const RingFigure& figure) {
  const auto faces_text = [](const RingPanel& panel, const char* otherwise) {
    std::string text;
    for (const RingFace& face : panel.faces) {
      std::vector<std::string> corners;
      for (const std::size_t corner : face.corners)
        corners.push_back(panel.vertices[corner].name);
      text += "  face " + face.name + (face.name.empty() ? "" : ": ") + join(corners, "-") +
              (face.differs ? otherwise : "") + "\n";
    }
    return text;
  };
  return "The faces around " + figure.picked + ".\nBefore:\n" + faces_text(figure.before, "") +
         "Yours:\n" + faces_text(figure.yours, " (not asked for)") + "Expected:\n" +
         faces_text(figure.expected, " (missing)");
}

std::string fault_text(const SurfaceFigure& figure) {
  return figure.is_misplaced ? "in a wrong place" : "with a wrong number of edges";
}

std::string figure_text(const SurfaceFigure& figure) {
  std::string text =
      "The mesh after the step: " + plural(figure.yours.triangles.size(), "triangle");
  if (figure.left_out > 0) {
    text +=
        " around the worst vertex; " + std::to_string(figure.left_out) + " more are left out";
  }
  text += ".\nVertices " + fault_text(figure) +
          ", the worst first: " + std::to_string(figure.marks.size()) + "\n";
  for (const SurfaceMark& mark : figure.marks)
    text += "  " + mark.name + ": " + mark.text + "\n";
  return text;
}

}  // namespace meshgrade
