#include "grader/judge/surface_figure.h"

#include <algorithm>
#include <cmath>

#include "grader/base/text.h"
#include "grader/judge/point_compare.h"

namespace meshgrade {
namespace {

/// A picture of more triangles than these shows none of them.
constexpr std::size_t kMostTriangles = 1200;
constexpr std::uint32_t kUnused = UINT32_MAX;

TriangleSurface surface_of(const MeshDump& mesh) {
  TriangleSurface surface;
  for (const FaceRecord& face : mesh.faces) {
    if (face.live == 0) continue;
    const HalfedgeRecord& x = mesh.halfedges[face.halfedge];
    const HalfedgeRecord& y = mesh.halfedges[x.next];
    surface.triangles.push_back({x.vertex, y.vertex, mesh.halfedges[y.next].vertex});
  }
  for (const VertexRecord& v : mesh.vertices)
    surface.positions.push_back(v.position);
  return surface;
}

/// Keeps the triangles that are nearest to a point, in their order. @return how many go
std::size_t keep_nearest(TriangleSurface& surface, const Point3& centre) {
  if (surface.triangles.size() <= kMostTriangles) return 0;
  std::vector<std::pair<double, std::size_t>> ranked;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    double off = 0.0;
    for (std::uint32_t v : surface.triangles[i])
      off = std::max(off, distance(surface.positions[v], centre));
    ranked.emplace_back(off, i);
  }
  std::nth_element(ranked.begin(), ranked.begin() + kMostTriangles, ranked.end());
  ranked.resize(kMostTriangles);
  std::sort(ranked.begin(), ranked.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<std::array<std::uint32_t, 3>> kept;
  for (const auto& [off, i] : ranked)
    kept.push_back(surface.triangles[i]);
  const std::size_t gone = surface.triangles.size() - kept.size();
  surface.triangles = std::move(kept);
  return gone;
}

/// Leaves out the vertices that no triangle uses.
/// @return the new number of each old vertex, or kUnused
std::vector<std::uint32_t> drop_unused_vertices(TriangleSurface& surface) {
  std::vector<std::uint32_t> number(surface.positions.size(), kUnused);
  std::vector<Point3> kept;
  for (auto& triangle : surface.triangles) {
    for (std::uint32_t& v : triangle) {
      if (number[v] == kUnused) {
        number[v] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(surface.positions[v]);
      }
      v = number[v];
    }
  }
  surface.positions = std::move(kept);
  return number;
}

/// Orders the marks and makes the figure small enough to be looked at.
void finish(SurfaceFigure& figure) {
  if (figure.empty()) return;  // all was deleted
  std::stable_sort(
      figure.marks.begin(), figure.marks.end(),
      [](const SurfaceMark& a, const SurfaceMark& b) { return a.error > b.error; });
  const SurfaceMark worst = figure.marks.empty() ? SurfaceMark{} : figure.marks[0];
  figure.left_out = keep_nearest(figure.yours, figure.yours.positions[worst.vertex]);
  keep_nearest(figure.expected, figure.expected.positions[worst.expected]);
  const std::vector<std::uint32_t> mine = drop_unused_vertices(figure.yours);
  const std::vector<std::uint32_t> right = drop_unused_vertices(figure.expected);
  for (SurfaceMark& mark : figure.marks) {
    mark.vertex = mine[mark.vertex];
    mark.expected = right[mark.expected];
  }
  std::erase_if(figure.marks, [](const SurfaceMark& mark) {
    return mark.vertex == kUnused || mark.expected == kUnused;
  });
}

}  // namespace

std::vector<std::size_t> valences(const MeshDump& mesh) {
  std::vector<std::size_t> valence(mesh.vertices.size(), 0);
  for (const HalfedgeRecord& h : mesh.halfedges) {
    if (h.live != 0) ++valence[h.vertex];
  }
  return valence;
}

SurfaceFigure figure_of_positions(const MeshDump& right, const std::vector<Point3>& expected,
                                  const MeshDump& mesh, const std::vector<Ref>& match,
                                  const std::vector<LocalScale>& scales) {
  SurfaceFigure figure{surface_of(mesh), surface_of(right), true, {}, 0};
  figure.expected.positions = expected;
  for (std::uint32_t v = 0; v < match.size(); ++v) {
    const Point3& actual = mesh.vertices[match[v]].position;
    const double error = distance(expected[v], actual);
    if (error <= scales[v].allowed) continue;
    figure.marks.push_back({match[v], v, vertex_name(match[v]),
                            "off by " + error_text(error, scales[v]) + ", at " +
                                point_text(actual) + ", must be at " + point_text(expected[v]),
                            error});
  }
  finish(figure);
  return figure;
}

SurfaceFigure figure_of_connectivity(const MeshDump& right, const MeshDump& mesh,
                                     const std::vector<Ref>& match) {
  SurfaceFigure figure{surface_of(mesh), surface_of(right), false, {}, 0};
  const std::vector<std::size_t> want = valences(right);
  const std::vector<std::size_t> have = valences(mesh);
  for (std::uint32_t v = 0; v < match.size(); ++v) {
    const Ref mine = match[v];
    if (mine >= have.size() || mesh.vertices[mine].live == 0 || have[mine] == want[v]) continue;
    figure.marks.push_back(
        {mine, v, vertex_name(mine),
         plural(have[mine], "edge") + ", must be " + std::to_string(want[v]),
         std::fabs(static_cast<double>(have[mine]) - static_cast<double>(want[v]))});
  }
  finish(figure);
  return figure;
}

}  // namespace meshgrade
