#include "grader/judge/surface_figure.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "grader/base/text.h"
#include "grader/judge/point_compare.h"

namespace meshgrade {
namespace {

/// A picture of more triangles shows none of them.
constexpr std::size_t kMostTriangles = 1200;

using Triangle = std::array<std::uint32_t, 3>;

std::vector<Triangle> triangles_of(const MeshDump& mesh) {
  std::vector<Triangle> triangles;
  for (const FaceRecord& face : mesh.faces) {
    if (face.live == 0) continue;
    const HalfedgeRecord& x = mesh.halfedges[face.halfedge];
    const HalfedgeRecord& y = mesh.halfedges[x.next];
    triangles.push_back({x.vertex, y.vertex, mesh.halfedges[y.next].vertex});
  }
  return triangles;
}

std::vector<Point3> positions_of(const MeshDump& mesh) {
  std::vector<Point3> positions;
  for (const VertexRecord& v : mesh.vertices)
    positions.push_back(v.position);
  return positions;
}

/// Keeps the triangles that are nearest to a point, in their order.
void keep_nearest(SurfaceFigure& figure, const Point3& centre) {
  if (figure.triangles.size() <= kMostTriangles) return;
  std::vector<std::pair<double, std::size_t>> ranked;
  for (std::size_t i = 0; i < figure.triangles.size(); ++i) {
    double off = 0.0;
    for (std::uint32_t v : figure.triangles[i])
      off = std::max(off, distance(figure.yours[v], centre));
    ranked.emplace_back(off, i);
  }
  std::nth_element(ranked.begin(), ranked.begin() + kMostTriangles, ranked.end());
  ranked.resize(kMostTriangles);
  std::sort(ranked.begin(), ranked.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  figure.left_out = figure.triangles.size() - kMostTriangles;
  std::vector<Triangle> kept;
  for (const auto& [off, i] : ranked)
    kept.push_back(figure.triangles[i]);
  figure.triangles = std::move(kept);
}

/// Leaves out the vertices that no triangle uses, and their marks.
void drop_unused_vertices(SurfaceFigure& figure) {
  constexpr std::uint32_t kUnused = UINT32_MAX;
  std::vector<std::uint32_t> number(figure.yours.size(), kUnused);
  SurfaceFigure small;
  small.left_out = figure.left_out;
  small.triangles = std::move(figure.triangles);
  for (Triangle& triangle : small.triangles) {
    for (std::uint32_t& v : triangle) {
      if (number[v] == kUnused) {
        number[v] = static_cast<std::uint32_t>(small.yours.size());
        small.yours.push_back(figure.yours[v]);
        if (!figure.expected.empty()) small.expected.push_back(figure.expected[v]);
      }
      v = number[v];
    }
  }
  for (SurfaceMark& mark : figure.marks) {
    if (number[mark.vertex] == kUnused) continue;
    mark.vertex = number[mark.vertex];
    small.marks.push_back(std::move(mark));
  }
  figure = std::move(small);
}

void finish(SurfaceFigure& figure) {
  std::stable_sort(
      figure.marks.begin(), figure.marks.end(),
      [](const SurfaceMark& a, const SurfaceMark& b) { return a.error > b.error; });
  if (!figure.marks.empty()) keep_nearest(figure, figure.yours[figure.marks[0].vertex]);
  if (figure.triangles.size() > kMostTriangles) {
    figure.left_out = figure.triangles.size() - kMostTriangles;
    figure.triangles.resize(kMostTriangles);
  }
  drop_unused_vertices(figure);
}

}  // namespace

SurfaceFigure figure_of_positions(const MeshDump& mesh, const std::vector<Ref>& match,
                                  const std::vector<Point3>& expected, double allowed,
                                  double size) {
  SurfaceFigure figure;
  figure.triangles = triangles_of(mesh);
  figure.yours = figure.expected = positions_of(mesh);
  for (std::size_t v = 0; v < match.size(); ++v) {
    const Ref mine = match[v];
    figure.expected[mine] = expected[v];
    const double error = distance(expected[v], figure.yours[mine]);
    if (error <= allowed) continue;
    figure.marks.push_back({mine, vertex_name(mine),
                            "off by " + number_text(error / size, 2) + " of the size, at " +
                                point_text(figure.yours[mine]) + ", must be at " +
                                point_text(expected[v]),
                            error});
  }
  finish(figure);
  return figure;
}

SurfaceFigure figure_of_connectivity(const MeshDump& mesh,
                                     const std::vector<std::size_t>& edges) {
  SurfaceFigure figure;
  figure.triangles = triangles_of(mesh);
  figure.yours = positions_of(mesh);
  std::vector<std::size_t> valence(mesh.vertices.size(), 0);
  for (const HalfedgeRecord& h : mesh.halfedges) {
    if (h.live != 0) ++valence[h.vertex];
  }
  for (Ref v = 0; v < std::min(edges.size(), valence.size()); ++v) {
    if (edges[v] == 0 || mesh.vertices[v].live == 0 || valence[v] == edges[v]) continue;
    figure.marks.push_back(
        {v, vertex_name(v),
         plural(valence[v], "edge") + ", must be " + std::to_string(edges[v]),
         std::fabs(static_cast<double>(valence[v]) - static_cast<double>(edges[v]))});
  }
  finish(figure);
  return figure;
}

}  // namespace meshgrade
