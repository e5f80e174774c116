#pragma once

#include <cstddef>
#include <vector>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// The control points of a tensor-product Bezier patch of degree (rows - 1, cols - 1).
/// points[r * cols + c] is column c of row r; rows and cols are at least 2.
struct ControlNet {
  std::size_t rows = 0;
  std::size_t cols = 0;
  std::vector<Point3> points;

  const Point3& at(std::size_t row, std::size_t col) const { return points[row * cols + col]; }
};

}  // namespace meshgrade
