#include "grader/subdivide/direct_catmull_clark.h"

#include <algorithm>
#include <array>
#include <utility>

namespace meshgrade {

DirectCatmullClark::DirectCatmullClark(const PolygonMesh& mesh)
    : DirectSurface(mesh, 4, "Catmull-Clark subdivision needs a manifold") {}

std::size_t DirectCatmullClark::n_faces_after(unsigned levels) const {
  return levels == 0 ? n_faces_ : n_corners() << (2 * (levels - 1));
}

/// Calls visit(f, first corner of f, end of its corners).
template <class Visit>
void DirectCatmullClark::visit_faces(std::size_t begin, std::size_t end, Visit visit) const {
  if (first_corner_.empty()) {
    for (std::size_t f = begin; f < end; ++f)
      visit(f, 4 * f, 4 * f + 4);
  } else {
    for (std::size_t f = begin; f < end; ++f)
      visit(f, std::size_t{first_corner_[f]}, std::size_t{first_corner_[f + 1]});
  }
}

Point3 DirectCatmullClark::face_point(std::size_t begin, std::size_t end) const {
  Point3 sum{};
  for (std::size_t c = begin; c < end; ++c)
    add(sum, positions_[corners_[c]]);
  for (double& x : sum)
    x /= static_cast<double>(end - begin);
  return sum;
}

/// Each face gives an edge a quarter of its own point, and half a quarter of each end.
void DirectCatmullClark::scatter_points(Point3* edge_points, Point3* face_points) const {
  std::fill_n(edge_points, n_edges_, Point3{});
  visit_faces(0, n_faces_, [&](std::size_t f, std::size_t begin, std::size_t end) {
    const Point3 middle = face_point(begin, end);
    face_points[f] = middle;
    std::size_t last = end - 1;
    for (std::size_t c = begin; c < end; last = c++) {
      const Point3& a = positions_[corners_[last]];
      const Point3& b = positions_[corners_[c]];
      Point3& point = edge_points[edges_[last]];
      for (std::size_t axis = 0; axis < 3; ++axis)
        point[axis] += middle[axis] / 4 + (a[axis] + b[axis]) / 8;
    }
  });
}

/// To each vertex the points of the faces around it, and its neighbours: each face gives the
/// one that comes next.
void DirectCatmullClark::scatter_neighbour_sums(Point3* sums) const {
  std::fill_n(sums, n_vertices_, Point3{});
  visit_faces(0, n_faces_, [&](std::size_t, std::size_t begin, std::size_t end) {
    const Point3 middle = face_point(begin, end);
    std::size_t last = end - 1;
    for (std::size_t c = begin; c < end; last = c++) {
      Point3& sum = sums[corners_[last]];
      add(sum, middle);
      add(sum, positions_[corners_[c]]);
    }
  });
}

void DirectCatmullClark::split_faces(std::size_t begin, std::size_t end, Index* corners,
                                     Index* edges) const {
  const auto first_point = static_cast<Index>(n_vertices_);
  const auto first_middle = static_cast<Index>(n_vertices_ + n_edges_);
  const auto first_inner = static_cast<Index>(2 * n_edges_);
  visit_faces(begin, end, [&](std::size_t f, std::size_t first, std::size_t stop) {
    const Index middle = first_middle + static_cast<Index>(f);
    std::size_t last = stop - 1;
    for (std::size_t c = first; c < stop; last = c++) {
      const std::size_t next = c + 1 == stop ? first : c + 1;
      const Index v = corners_[c];
      // The halves at v of the edges that leave it and come to it.
      const Index leaving = 2 * edges_[c] + (v > corners_[next] ? 1 : 0);
      const Index coming = 2 * edges_[last] + (v > corners_[last] ? 1 : 0);
      const std::array<Index, 4> new_corners = {v, first_point + edges_[c], middle,
                                                first_point + edges_[last]};
      const std::array<Index, 4> new_edges = {leaving, first_inner + static_cast<Index>(c),
                                              first_inner + static_cast<Index>(last), coming};
      std::copy(new_corners.begin(), new_corners.end(), corners + 4 * c);
      std::copy(new_edges.begin(), new_edges.end(), edges + 4 * c);
    }
  });
}

void DirectCatmullClark::finish_interior(Point3* new_positions) const {
  for (std::size_t v = 0; v < first_valence_.size(); ++v) {
    const Index valence = first_valence_[v];
    if (valence == kBoundary || valence == kCornerOfOneFace) continue;
    const double n = valence;
    blend(new_positions[v], positions_[v], (n - 2) / n, 1 / (n * n));
  }
  for (const VertexRange& range : later_vertices_) {
    for (std::size_t v = range.end_of_boundary; v < range.end; ++v)
      blend(new_positions[v], positions_[v], 1.0 / 2, 1.0 / 16);
  }
}

/// The middle of a face has as many neighbours as the face has corners: four, but on the first
/// level. The points of edges have four, or lie on a boundary.
void DirectCatmullClark::note_new_vertices() {
  const std::size_t end_of_boundary = n_vertices_ + boundary_edges_.size();
  if (first_corner_.empty()) {
    later_vertices_.push_back(
        {n_vertices_, end_of_boundary, n_vertices_ + n_edges_ + n_faces_});
    return;
  }
  first_valence_.resize(end_of_boundary, kBoundary);
  first_valence_.resize(n_vertices_ + n_edges_, 4);
  visit_faces(0, n_faces_, [&](std::size_t, std::size_t begin, std::size_t end) {
    first_valence_.push_back(static_cast<Index>(end - begin));
  });
}

void DirectCatmullClark::subdivide_once(const SubdivisionOptions& options, double done,
                                        double share) {
  const std::size_t n_vertices = n_vertices_ + n_edges_ + n_faces_;
  Level level{make_big_array<Point3>(n_vertices), make_big_array<Index>(4 * n_corners()),
              make_big_array<Index>(4 * n_corners())};
  Point3* const points = level.positions.get();
  share_work(
      options, done, share,
      [&] { scatter_points(points + n_vertices_, points + n_vertices_ + n_edges_); },
      [&] {
        scatter_neighbour_sums(points);
        finish_interior(points);
      },
      [&](std::size_t begin, std::size_t end) {
        split_faces(begin, end, level.corners.get(), level.edges.get());
      });
  finish_boundary(points, options);
  note_new_vertices();
  take(std::move(level), n_vertices, n_corners());
}

PolygonMesh direct_catmull_clark(const PolygonMesh& mesh, const SubdivisionOptions& options) {
  DirectCatmullClark surface(mesh);
  surface.subdivide(options);
  return surface.polygon_mesh();
}

}  // namespace meshgrade
