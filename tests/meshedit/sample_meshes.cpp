#include "sample_meshes.h"

#include <cmath>

namespace meshedit {

HalfedgeMesh mesh_of(const Polygons& polygons) {
  HalfedgeMesh mesh;
  mesh.build(polygons.corners, polygons.positions);
  return mesh;
}

Polygons triangle() {
  return {{{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
}

Polygons diamond() {
  return {{{0, 1, 2}, {3, 2, 1}}, {{0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}}};
}

Polygons tetrahedron() {
  return {{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
          {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
}

Polygons octahedron() {
  return {
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
}

Polygons cube_of_squares() {
  Polygons cube;
  for (Index i = 0; i < 8; ++i) {
    cube.positions.emplace_back((i & 1U) != 0 ? 1.0 : -1.0, (i & 2U) != 0 ? 1.0 : -1.0,
                                (i & 4U) != 0 ? 1.0 : -1.0);
  }
  cube.corners = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return cube;
}

Polygons cube_with_centers() {
  const Polygons squares = cube_of_squares();
  Polygons cube{{}, squares.positions};
  for (const std::vector<Index>& square : squares.corners) {
    const Index center = cube.positions.size();
    cube.positions.push_back((squares.positions[square[0]] + squares.positions[square[2]]) / 2);
    for (Index i = 0; i < 4; ++i) {
      cube.corners.push_back({square[i], square[(i + 1) % 4], center});
    }
  }
  return cube;
}

namespace {

// Vertices lie in `stride` columns; a square's right and upper neighbours may wrap around.
void add_square(Polygons& mesh, Index lower_left, Index lower_right, Index upper_right,
                Index upper_left) {
  mesh.corners.push_back({lower_left, lower_right, upper_right});
  mesh.corners.push_back({lower_left, upper_right, upper_left});
}

}  // namespace

Polygons sheet(Index columns, Index rows) {
  Polygons mesh;
  const Index stride = columns + 1;
  for (Index j = 0; j <= rows; ++j) {
    for (Index i = 0; i <= columns; ++i) {
      mesh.positions.emplace_back(static_cast<double>(i), static_cast<double>(j), 0.0);
    }
  }
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Index v = j * stride + i;
      add_square(mesh, v, v + 1, v + stride + 1, v + stride);
    }
  }
  return mesh;
}

Polygons torus(Index columns, Index rows) {
  Polygons mesh;
  const auto angle = [](Index i, Index n) {
    return 2.0 * std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(n);
  };
  for (Index j = 0; j < rows; ++j) {
    const double around_tube = angle(j, rows);
    for (Index i = 0; i < columns; ++i) {
      const double r = 3.0 + std::cos(around_tube);
      mesh.positions.emplace_back(r * std::cos(angle(i, columns)),
                                  r * std::sin(angle(i, columns)), std::sin(around_tube));
    }
  }
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Index right = (i + 1) % columns;
      const Index row = j * columns;
      const Index above = (j + 1) % rows * columns;
      add_square(mesh, row + i, row + right, above + right, above + i);
    }
  }
  return mesh;
}

Polygons frame() {
  Polygons mesh = sheet(3, 3);
  mesh.corners.erase(mesh.corners.begin() + 8, mesh.corners.begin() + 10);
  return mesh;
}

Polygons fan(Index n, bool closed) {
  Polygons mesh;
  mesh.positions.emplace_back(0, 0, 0);
  const Index rim = closed ? n : n + 1;
  for (Index i = 0; i < rim; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * static_cast<double>(i) /
                         static_cast<double>(n + (closed ? 0 : 2));
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  for (Index i = 0; i < n; ++i) {
    mesh.corners.push_back({0, 1 + i, 1 + (i + 1) % rim});
  }
  return mesh;
}

Polygons together(const Polygons& a, const Polygons& b) {
  Polygons both = a;
  both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
  for (std::vector<Index> polygon : b.corners) {
    for (Index& corner : polygon) {
      corner += a.positions.size();
    }
    both.corners.push_back(polygon);
  }
  return both;
}

std::vector<Polygons> all_triangle_meshes() {
  return {
      triangle(),          diamond(),    tetrahedron(), octahedron(),
      cube_with_centers(), sheet(4, 3),  torus(5, 4),   frame(),
      fan(7, false),       fan(7, true), fan(3, true),  together(octahedron(), sheet(2, 2))};
}

}  // namespace meshedit
