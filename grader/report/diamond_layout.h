#pragma once

// Where the elements around an edge are drawn. Vertices are placed by their parts, a above, b
// to the left, c to the right, d below, m in the middle, and not where they are in space: so
// the thinnest triangles stay readable.

#include "grader/judge/neighbourhood_figure.h"
#include "grader/report/svg_pen.h"

namespace meshgrade {

/// A half-edge as an arrow beside its edge, inside its face.
struct HalfedgeArrow {
  Spot tail;
  Spot tip;
  Spot turn;   ///< where the way to the next half-edge bends
  Spot label;  ///< the middle of its name

  Spot direction() const { return unit(tip - tail); }
  Spot at(double part) const { return tail + part * (tip - tail); }
};

/// Coordinates are those of the panel, with the middle of the edge between b and c at (0, 0).
class DiamondLayout {
 public:
  explicit DiamondLayout(const FigurePanel& panel);

  const HalfedgeArrow& arrow(std::size_t halfedge) const { return arrows_[halfedge]; }
  Spot vertex(std::size_t i) const { return vertices_[i]; }
  Spot edge_start(std::size_t i) const { return edges_[i][0]; }
  Spot edge_end(std::size_t i) const { return edges_[i][1]; }
  Spot edge_label(std::size_t i) const { return 0.5 * (edges_[i][0] + edges_[i][1]); }
  /// Empty for a boundary loop.
  const std::vector<Spot>& face_corners(std::size_t i) const { return faces_[i]; }
  Spot face_label(std::size_t i) const { return face_labels_[i]; }

  /// What the panel takes up.
  const Box& frame() const { return frame_; }

 private:
  std::vector<HalfedgeArrow> arrows_;
  std::vector<Spot> vertices_;
  std::vector<std::array<Spot, 2>> edges_;
  std::vector<std::vector<Spot>> faces_;
  std::vector<Spot> face_labels_;
  Box frame_;
};

}  // namespace meshgrade
