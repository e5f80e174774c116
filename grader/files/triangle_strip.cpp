#include "grader/files/triangle_strip.h"

namespace meshgrade {
namespace {

using Triangles = std::vector<std::vector<std::uint32_t>>;

void add_triangle(Triangles& triangles, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a != b && b != c && c != a) triangles.push_back({a, b, c});
}

}  // namespace

Triangles cut_strips(const std::vector<std::uint32_t>& strips) {
  Triangles triangles;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < strips.size(); ++k) {
    if (strips[k] == kStripEnd) {
      begin = k + 1;
    } else if (k >= begin + 2) {
      const bool is_turned = (k - begin) % 2 == 1;
      add_triangle(triangles, strips[is_turned ? k - 1 : k - 2],
                   strips[is_turned ? k - 2 : k - 1], strips[k]);
    }
  }
  return triangles;
}

Triangles cut_fan(const std::vector<std::uint32_t>& fan) {
  Triangles triangles;
  for (std::size_t k = 2; k < fan.size(); ++k)
    add_triangle(triangles, fan[0], fan[k - 1], fan[k]);
  return triangles;
}

}  // namespace meshgrade
