#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace meshgrade {

using Point2 = std::array<double, 2>;
using Point3 = std::array<double, 3>;

/// A mesh as files have it: positions, and polygons as lists of indices into them,
/// counter-clockwise seen from outside. Nothing is promised about validity: building a
/// half-edge mesh tells.
struct PolygonMesh {
  std::vector<Point3> positions;
  std::vector<std::vector<std::uint32_t>> polygons;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(positions, polygons);
  }
};

}  // namespace meshgrade
