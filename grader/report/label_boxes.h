#pragma once

#include <cmath>
#include <vector>

#include "grader/report/svg_pen.h"

namespace meshgrade {

/// Finds places for labels, so that none lies on another.
class LabelBoxes {
 public:
  explicit LabelBoxes(const Box& frame) : frame_(frame) {}

  void take(const Box& box) { taken_.push_back(box); }

  /// Takes the first of the wanted places that is free; if there is none, the free place that
  /// is nearest to the first.
  Spot place(const std::vector<Spot>& wanted, double width, double height) {
    for (Spot spot : wanted) {
      if (take_if_free(spot, width, height)) return spot;
    }
    for (double radius = 8.0; radius < 400.0; radius += 8.0) {
      for (int i = 0; i < 16; ++i) {
        const double angle = 0.3927 * i;
        const Spot spot = wanted[0] + radius * Spot{std::cos(angle), std::sin(angle)};
        if (take_if_free(spot, width, height)) return spot;
      }
    }
    return wanted[0];
  }

 private:
  bool take_if_free(Spot spot, double width, double height) {
    const Box box = box_around(spot, width, height);
    if (box.x0 < frame_.x0 || box.x1 > frame_.x1 || box.y0 < frame_.y0 || box.y1 > frame_.y1) {
      return false;
    }
    for (const Box& other : taken_) {
      if (overlap(box, other)) return false;
    }
    take(box);
    return true;
  }

  Box frame_;
  std::vector<Box> taken_;
};

}  // namespace meshgrade
