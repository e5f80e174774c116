#include "grader/report/diamond_layout.h"

#include <cmath>

namespace meshgrade {
namespace {

constexpr double kRadius = 160.0;  // of the diamond
constexpr double kInset = 15.0;    // of an arrow, from its edge
constexpr double kGap = 7.0;       // between an arrow and where it turns into the next
constexpr double kFarGap = 30.0;   // between an arrow on a far side and its corners
constexpr Spot kStub{34.0, 84.0};  // of a half-edge that leaves the picture below
constexpr double kLabelShift = 19.0;
constexpr double kSlantedShift = 29.0;

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

/// A bit below the incentre, where the label of a slanted arrow leaves more room.
Spot label_in(const std::vector<Spot>& t) {
  const double p = length(t[1] - t[2]);
  const double q = length(t[2] - t[0]);
  const double r = length(t[0] - t[1]);
  const Spot incentre = (1.0 / (p + q + r)) * (p * t[0] + q * t[1] + r * t[2]);
  return {incentre.x, 0.7 * incentre.y};
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

/// The label of an arrow, beside the middle of its edge, where the edge has its own label.
/// Those of two twins move apart along the edge; those of slanted arrows keep away from the
/// middle column: inside they go towards b or c, outside towards a or d.
Spot label_on(const HalfedgeArrow& arrow, const std::string& ends, bool outside) {
  if (ends.find('-') != std::string::npos) return arrow.at(0.35);
  const Spot direction = arrow.direction();
  const Spot middle = 0.5 * (corner(ends[0]) + corner(ends[1])) - arrow.tail;
  const double along = middle.x * direction.x + middle.y * direction.y;
  const bool from_side = ends[0] == 'b' || ends[0] == 'c';
  const bool slanted = std::fabs(direction.x * direction.y) > 0.1;
  if (!slanted) return arrow.tail + (along - kLabelShift) * direction;
  const double shift = from_side == outside ? kSlantedShift : -kSlantedShift;
  return arrow.tail + (along + shift) * direction;
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
  arrow.label = label_on(arrow, ends, false);
  return arrow;
}

/// Where a half-edge that leaves the picture at a corner of the boundary is cut off.
Spot stub_end(char letter) {
  const Spot start = corner(letter);
  return start + Spot{start.x < 0.0 ? -kStub.x : kStub.x, kStub.y};
}

HalfedgeArrow outer_arrow(const std::string& ends) {
  Spot p = corner(ends[0]);
  Spot q = corner(ends[1]);

  if (ends[0] == '-') p = stub_end(ends[1]);
  if (ends[1] == '-') q = stub_end(ends[0]);
  const Spot direction = unit(q - p);
  const bool stub = ends.find('-') != std::string::npos;
  const Spot aside = (stub ? 6.0 : kInset) * left_of(direction);
  HalfedgeArrow arrow;
  arrow.tail = p + (ends[0] == '-' ? 0.0 : kFarGap) * direction + aside;
  arrow.tip = q - (ends[1] == '-' ? 0.0 : kFarGap) * direction + aside;
  arrow.turn = arrow.tip + kGap * direction;
  arrow.label = label_on(arrow, ends, true);
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
    face_labels_.push_back(corners.empty() ? Spot{0.0, 62.0} : label_in(corners));
    faces_.push_back(std::move(corners));
  }
  for (const FigureElement& h : panel.of(ElementKind::kHalfedge)) {
    arrows_.push_back(h.outside ? outer_arrow(h.corners)
                                : inner_arrow(h.corners, opposite(panel, h.corners)));
  }
  const double below = whole ? kRadius + 28.0 : 112.0;
  frame_ = {-kRadius - 36.0, -kRadius - 36.0, kRadius + 36.0, below};
}

}  // namespace meshgrade
