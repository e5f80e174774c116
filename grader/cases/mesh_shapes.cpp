#include "grader/cases/mesh_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meshgrade {

PolygonMesh in_build_order(const PolygonMesh& mesh) {
  PolygonMesh ordered;
  constexpr std::uint32_t kNone = UINT32_MAX;
  std::vector<std::uint32_t> number(mesh.positions.size(), kNone);
  for (const auto& polygon : mesh.polygons) {
    auto& corners = ordered.polygons.emplace_back();
    for (std::uint32_t corner : polygon) {
      if (number[corner] == kNone) {
        number[corner] = static_cast<std::uint32_t>(ordered.positions.size());
        ordered.positions.push_back(mesh.positions[corner]);
      }
      corners.push_back(number[corner]);
    }
  }
  return ordered;
}

PolygonMesh beginning_at_highest_valence(PolygonMesh mesh) {
  std::vector<std::uint32_t> valence(mesh.positions.size(), 0);
  for (const auto& polygon : mesh.polygons) {
    for (std::uint32_t corner : polygon)
      ++valence[corner];
  }
  const auto highest = static_cast<std::uint32_t>(
      std::max_element(valence.begin(), valence.end()) - valence.begin());
  for (auto& polygon : mesh.polygons) {
    const auto corner = std::find(polygon.begin(), polygon.end(), highest);
    if (corner == polygon.end()) continue;
    std::rotate(polygon.begin(), corner, polygon.end());
    std::swap(polygon, mesh.polygons.front());
    break;
  }
  return in_build_order(mesh);
}

PolygonMesh jittered(const PolygonMesh& mesh, double amount, Random& random) {
  const auto move = [&](double x) { return x + random.between(-amount, amount); };
  return mapped(mesh, [&](const Point3& p) {
    return Point3{move(p[0]), move(2.0 * p[1]), move(0.5 * p[2])};
  });
}

PolygonMesh bipyramid(std::uint32_t n) {
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.0});
  }
  mesh.positions.push_back({0.0, 0.0, 1.0});
  mesh.positions.push_back({0.0, 0.0, -0.5});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.polygons.push_back({i, j, n});
    mesh.polygons.push_back({j, i, n + 1});
  }
  return in_build_order(mesh);
}

PolygonMesh prism(std::uint32_t n) {
  PolygonMesh mesh;
  std::vector<std::uint32_t> base;
  std::vector<std::uint32_t> top;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    mesh.positions.push_back({2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0});
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 1.5});
    base.insert(base.begin(), 2 * i);
    top.push_back(2 * i + 1);
    const std::uint32_t next = 2 * ((i + 1) % n);
    mesh.polygons.push_back({2 * i, next, next + 1, 2 * i + 1});
  }
  mesh.polygons.push_back(base);
  mesh.polygons.push_back(top);
  return mesh;
}

PolygonMesh quad_grid(std::uint32_t columns, std::uint32_t rows) {
  PolygonMesh mesh;
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x)
      mesh.positions.push_back({static_cast<double>(x), static_cast<double>(y), 0.0});
  }
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return y * (columns + 1) + x; };
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x)
      mesh.polygons.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
  }
  return mesh;
}

TriangleSet::TriangleSet(const PolygonMesh& mesh)
    : vertices_(static_cast<std::uint32_t>(mesh.positions.size())) {
  for (const auto& t : mesh.polygons)
    add(t.at(0), t.at(1), t.at(2));
}

std::vector<VertexPair> TriangleSet::edges() const {
  std::vector<VertexPair> result;
  for (const auto& [edge, third] : third_) {
    if (edge.first < edge.second) {
      result.push_back(edge);
    } else if (third_.count({edge.second, edge.first}) == 0) {
      result.emplace_back(edge.second, edge.first);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool TriangleSet::has_edge(std::uint32_t a, std::uint32_t b) const {
  return third_.count({a, b}) != 0 || third_.count({b, a}) != 0;
}

bool TriangleSet::is_boundary(VertexPair edge) const {
  return third_.count(edge) == 0 || third_.count({edge.second, edge.first}) == 0;
}

VertexPair TriangleSet::opposite(VertexPair edge) const {
  return {third_.at(edge), third_.at({edge.second, edge.first})};
}

bool TriangleSet::can_flip(VertexPair edge) const {
  if (is_boundary(edge)) return false;
  const auto [c, d] = opposite(edge);
  return c != d && !has_edge(c, d);
}

VertexPair TriangleSet::flip(VertexPair edge) {
  const auto [a, b] = edge;
  const auto [c, d] = opposite(edge);
  remove(a, b);
  remove(b, a);
  add(a, d, c);
  add(b, c, d);
  return std::minmax(c, d);
}

std::uint32_t TriangleSet::split(VertexPair edge) {
  const std::uint32_t m = vertices_++;
  for (const auto& [a, b] : {edge, VertexPair{edge.second, edge.first}}) {
    const auto side = third_.find({a, b});
    if (side == third_.end()) continue;
    const std::uint32_t c = side->second;
    remove(a, b);
    add(a, m, c);
    add(m, b, c);
  }
  return m;
}

void TriangleSet::add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  third_[{a, b}] = c;
  third_[{b, c}] = a;
  third_[{c, a}] = b;
}

void TriangleSet::remove(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t c = third_.at({a, b});
  third_.erase({a, b});
  third_.erase({b, c});
  third_.erase({c, a});
}

}  // namespace meshgrade
