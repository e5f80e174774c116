#include "grader/subdivide/direct_loop.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "grader/subdivide/loop_rules.h"

namespace meshgrade {

DirectLoop::DirectLoop(const PolygonMesh& mesh)
    : DirectSurface(require_triangles(mesh), 3, kLoopNeeds) {
  first_corner_.clear();
}

std::size_t DirectLoop::n_faces_after(unsigned levels) const {
  return n_faces_ << (2 * levels);
}

void DirectLoop::scatter_edge_points(Point3* edge_points) const {
  std::fill_n(edge_points, n_edges_, Point3{});
  for (std::size_t h = 0; h < 3 * n_faces_; h += 3) {
    const Point3& a = positions_[corners_[h]];
    const Point3& b = positions_[corners_[h + 1]];
    const Point3& c = positions_[corners_[h + 2]];
    Point3& ab = edge_points[edges_[h]];
    Point3& bc = edge_points[edges_[h + 1]];
    Point3& ca = edge_points[edges_[h + 2]];
    // Each face gives half of 3/8 for the ends of the edge, and 1/8 for the corner across.
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double all = 3.0 / 16.0 * (a[axis] + b[axis] + c[axis]);
      ab[axis] += all - 1.0 / 16.0 * c[axis];
      bc[axis] += all - 1.0 / 16.0 * a[axis];
      ca[axis] += all - 1.0 / 16.0 * b[axis];
    }
  }
}

void DirectLoop::scatter_neighbour_sums(Point3* sums) const {
  std::fill_n(sums, n_vertices_, Point3{});
  for (std::size_t h = 0; h < 3 * n_faces_; h += 3) {
    const Index a = corners_[h];
    const Index b = corners_[h + 1];
    const Index c = corners_[h + 2];
    add(sums[a], positions_[b]);
    add(sums[b], positions_[c]);
    add(sums[c], positions_[a]);
  }
}

void DirectLoop::split_faces(std::size_t begin, std::size_t end, Index* corners,
                             Index* edges) const {
  const auto first_point = static_cast<Index>(n_vertices_);
  const auto first_inner = static_cast<Index>(2 * n_edges_);
  for (std::size_t f = begin; f < end; ++f) {
    const Index* v = &corners_[3 * f];
    const Index* e = &edges_[3 * f];
    const std::array<Index, 3> point = {first_point + e[0], first_point + e[1],
                                        first_point + e[2]};
    // Halves of edge k: the one at corner k, then the one at corner k + 1.
    std::array<std::array<Index, 2>, 3> half;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index is_higher = v[k] > v[(k + 1) % 3] ? 1 : 0;
      half[k] = {2 * e[k] + is_higher, 2 * e[k] + 1 - is_higher};
    }
    const Index inner = first_inner + static_cast<Index>(3 * f);
    const std::array<Index, 12> new_corners = {v[0],     point[0], point[2], v[1],
                                               point[1], point[0], v[2],     point[2],
                                               point[1], point[0], point[1], point[2]};
    const std::array<Index, 12> new_edges = {half[0][0], inner + 2,  half[2][1], half[1][0],
                                             inner,      half[0][1], half[2][0], inner + 1,
                                             half[1][1], inner,      inner + 1,  inner + 2};
    std::copy(new_corners.begin(), new_corners.end(), corners + 12 * f);
    std::copy(new_edges.begin(), new_edges.end(), edges + 12 * f);
  }
}

void DirectLoop::finish_interior(Point3* new_positions, VertexRule rule) const {
  for (std::size_t v = 0; v < first_valence_.size(); ++v) {
    const Index valence = first_valence_[v];
    if (valence == kBoundary || valence == kCornerOfOneFace) continue;
    const double weight = neighbour_weight(rule, valence);
    blend(new_positions[v], positions_[v], 1 - valence * weight, weight);
  }
  const double weight = neighbour_weight(rule, 6);
  for (const VertexRange& range : later_vertices_) {
    for (std::size_t v = range.end_of_boundary; v < range.end; ++v) {
      blend(new_positions[v], positions_[v], 1 - 6 * weight, weight);
    }
  }
}

void DirectLoop::subdivide_once(const SubdivisionOptions& options, double done, double share) {
  Level level{make_big_array<Point3>(n_vertices_ + n_edges_),
              make_big_array<Index>(12 * n_faces_), make_big_array<Index>(12 * n_faces_)};
  share_work(
      options, done, share, [&] { scatter_edge_points(level.positions.get() + n_vertices_); },
      [&] {
        scatter_neighbour_sums(level.positions.get());
        finish_interior(level.positions.get(), options.vertex_rule);
      },
      [&](std::size_t begin, std::size_t end) {
        split_faces(begin, end, level.corners.get(), level.edges.get());
      });
  finish_boundary(level.positions.get(), options);
  later_vertices_.push_back(
      {n_vertices_, n_vertices_ + boundary_edges_.size(), n_vertices_ + n_edges_});
  take(std::move(level), n_vertices_ + n_edges_, 4 * n_faces_);
}

PolygonMesh direct_loop(const PolygonMesh& mesh, const SubdivisionOptions& options) {
  DirectLoop surface(mesh);
  surface.subdivide(options);
  return surface.polygon_mesh();
}

}  // namespace meshgrade
