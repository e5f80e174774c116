#include "grader/report/diamond_layout.h"

#include <cmath>

namespace meshgrade {
namespace {

constexpr double kRadius = 160.0;  // of the diamond
constexpr double kInset = 15.0;    // of an arrow, from its edge
constexpr double kGap = 7.0;       // between an arrow and where it turns into the next
constexpr double kFarGap = 30.0;   // between an arrow on a far side and its corners
constexpr Spot kStub{34.0, 84.0};  // of a half-edge that leaves the picture below
constexpr double kLabelPart = 0.33;

Spot corner(char letter) {
  switch (letter) {
    case 'a':
      return {0.0, -kRadius};
    case 'b':
      return {-kRadius, 0.0};
    case 'c':
      return {kRadius, 0.0};
    case 'd':
      return {0.0, kRadius};
    default:
      return {0.0, 0.0};
  }
}

/// The corner at p of the triangle p, q, r when all its sides move inside.
Spot inset_corner(Spot p, Spot q, Spot r) {
  const Spot u = unit(q - p);
  const Spot v = unit(r - p);
  const double sine = std::fabs(u.x * v.y - u.y * v.x);
  return p + (kInset / sine) * (u + v);
}

Spot incentre(const std::vector<Spot>& t) {
  const double p = length(t[1] - t[2]);
  const double q = length(t[2] - t[0]);
  const double r = length(t[0] - t[1]);
  return (1.0 / (p + q + r)) * (p * t[0] + q * t[1] + r * t[2]);
}

/// The letter of the third corner of the face that has this side; '-' if there is none.
char opposite(const FigurePanel& panel, const std::string& side) {
  for (const FigureElement& face : panel.of(ElementKind::kFace)) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const char next = face.corners[(i + 1) % 3];
      if (side[0] == face.corners[i] && side[1] == next) return face.corners[(i + 2) % 3];
    }
  }
  return '-';
}

/// Labels of slanted arrows keep away from the middle column: inside they go towards b or c,
/// outside towards a or d.
double label_part(const std::string& ends, bool outside) {
  const bool from_side = ends[0] == 'b' || ends[0] == 'c';
  const bool to_side = ends[1] == 'b' || ends[1] == 'c';
  if (from_side == to_side || ends.find('m') != std::string::npos) return kLabelPart;
  return from_side != outside ? kLabelPart : 1.0 - kLabelPart;
}

HalfedgeArrow inner_arrow(const std::string& ends, char third) {
  const Spot p = corner(ends[0]);
  const Spot q = corner(ends[1]);
  const Spot r = corner(third);
  HalfedgeArrow arrow;
  const Spot start = inset_corner(p, q, r);
  arrow.turn = inset_corner(q, r, p);
  const Spot direction = unit(q - p);
  arrow.tail = start + kGap * direction;
  arrow.tip = arrow.turn - kGap * direction;
  arrow.label = arrow.at(label_part(ends, false));
  return arrow;
}

HalfedgeArrow outer_arrow(const std::string& ends) {
  Spot p = corner(ends[0]);
  Spot q = corner(ends[1]);
  Spot aside;
  if (ends[0] == '-') {
    p = q + kStub;
  } else if (ends[1] == '-') {
    q = p + Spot{-kStub.x, kStub.y};
  } else {
    aside = kInset * left_of(unit(q - p));
  }
  const Spot direction = unit(q - p);
  HalfedgeArrow arrow;
  arrow.tail = p + (ends[0] == '-' ? 0.0 : kFarGap) * direction + aside;
  arrow.tip = q - (ends[1] == '-' ? 0.0 : kFarGap) * direction + aside;
  arrow.turn = arrow.tip + kGap * direction;
  arrow.label = arrow.at(label_part(ends, true));
  return arrow;
}

}  // namespace

DiamondLayout::DiamondLayout(const FigurePanel& panel) {
  bool whole = false;
  for (const FigureElement& vertex : panel.of(ElementKind::kVertex)) {
    vertices_.push_back(corner(vertex.corners[0]));
    whole = whole || vertex.corners == "d";
  }
  for (const FigureElement& edge : panel.of(ElementKind::kEdge)) {
    edges_.push_back({corner(edge.corners[0]), corner(edge.corners[1])});
  }
  for (const FigureElement& face : panel.of(ElementKind::kFace)) {
    std::vector<Spot> corners;
    for (char letter : face.corners)
      corners.push_back(corner(letter));
    face_labels_.push_back(corners.empty() ? Spot{0.0, 62.0} : incentre(corners));
    faces_.push_back(std::move(corners));
  }
  for (const FigureElement& h : panel.of(ElementKind::kHalfedge)) {
    arrows_.push_back(h.outside ? outer_arrow(h.corners)
                                : inner_arrow(h.corners, opposite(panel, h.corners)));
  }
  const double below = whole ? kRadius + 28.0 : 100.0;
  frame_ = {-kRadius - 48.0, -kRadius - 28.0, kRadius + 48.0, below};
}

}  // namespace meshgrade
