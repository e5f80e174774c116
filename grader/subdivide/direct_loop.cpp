#include "grader/subdivide/direct_loop.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <string>
#include <thread>

namespace meshgrade {
namespace {

using Index = std::uint32_t;

constexpr Index kNone = std::numeric_limits<Index>::max();

// Marks among the valences, which are 3 or more inside.
constexpr Index kBoundary = 0;
constexpr Index kCornerOfOneFace = 1;

constexpr std::size_t kChunk = 1U << 11U;  // faces that one thread splits at a time

std::size_t next_corner(std::size_t h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
std::size_t previous_corner(std::size_t h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

[[noreturn]] void refuse(const std::string& what) {
  throw LoopError(what + "; Loop subdivision needs a manifold of triangles");
}

std::string edge_name(Index a, Index b) {
  return "the edge from v" + std::to_string(a) + " to v" + std::to_string(b);
}

std::string face_name(std::size_t half_edge) {
  std::string name = "f";
  return name += std::to_string(half_edge / 3);
}

/// A half-edge, filed under the lower of its ends.
struct FiledEdge {
  Index higher_end;
  Index half_edge;
};

/// Half-edges by lower end: those of vertex v are [begin[v], begin[v + 1]).
struct EdgeFile {
  std::vector<Index> begin;
  std::vector<FiledEdge> filed;
};

EdgeFile file_edges(const Index* corners, std::size_t n_corners, std::size_t n_vertices) {
  EdgeFile file;
  file.begin.assign(n_vertices + 1, 0);
  const auto lower_end = [&](std::size_t h) {
    return std::min(corners[h], corners[next_corner(h)]);
  };
  for (std::size_t h = 0; h < n_corners; ++h)
    ++file.begin[lower_end(h) + 1];
  for (std::size_t v = 0; v < n_vertices; ++v)
    file.begin[v + 1] += file.begin[v];
  file.filed.resize(n_corners);
  std::vector<Index> next = file.begin;
  for (std::size_t h = 0; h < n_corners; ++h) {
    const Index higher = std::max(corners[h], corners[next_corner(h)]);
    file.filed[next[lower_end(h)]++] = {higher, static_cast<Index>(h)};
  }
  return file;
}

/// Pairs the half-edges [begin, end), which share their lower end.
void pair_edges(FiledEdge* begin, FiledEdge* end, const Index* corners,
                std::vector<Index>& twins) {
  std::sort(begin, end, [](const FiledEdge& a, const FiledEdge& b) {
    return std::pair(a.higher_end, a.half_edge) < std::pair(b.higher_end, b.half_edge);
  });
  for (const FiledEdge* at = begin; at != end;) {
    const FiledEdge* stop = at;
    while (stop != end && stop->higher_end == at->higher_end)
      ++stop;
    if (stop - at > 1) {
      const Index h = at[0].half_edge;
      const Index t = at[1].half_edge;
      const std::string name = edge_name(corners[h], corners[next_corner(h)]);
      if (stop - at > 2) {
        refuse(name + " has " + std::to_string(stop - at) + " faces (" + face_name(h) + ", " +
               face_name(t) + ", " + face_name(at[2].half_edge) + " ...)");
      }
      if (corners[h] == corners[t]) {
        refuse(name + " is run in the same direction by " + face_name(h) + " and " +
               face_name(t));
      }
      twins[h] = t;
      twins[t] = h;
    }
    at = stop;
  }
}

std::vector<Index> find_twins(const Index* corners, std::size_t n_corners,
                              std::size_t n_vertices) {
  EdgeFile file = file_edges(corners, n_corners, n_vertices);
  std::vector<Index> twins(n_corners, kNone);
  for (std::size_t v = 0; v < n_vertices; ++v) {
    pair_edges(file.filed.data() + file.begin[v], file.filed.data() + file.begin[v + 1],
               corners, twins);
  }
  return twins;
}

/// Calls work(0) ... work(n - 1), each once, from several threads. `after` is called in the
/// calling thread with the number of calls that have begun.
void run_parallel(unsigned n_threads, std::size_t n,
                  const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t)>& after) {
  std::atomic<std::size_t> next = 0;
  const auto help = [&] {
    for (std::size_t k = next++; k < n; k = next++)
      work(k);
  };
  std::vector<std::jthread> helpers;
  for (unsigned t = 1; t < std::min<std::size_t>(n_threads, n); ++t)
    helpers.emplace_back(help);
  for (std::size_t k = next++; k < n; k = next++) {
    work(k);
    after(k + 1);
  }
}

void add(Point3& sum, const Point3& term) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    sum[axis] += term[axis];
}

/// keep * old + weight * sum, into sum.
void blend(Point3& sum, const Point3& old, double keep, double weight) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum[axis] = keep * old[axis] + weight * sum[axis];
  }
}

}  // namespace

DirectLoop::DirectLoop(const PolygonMesh& mesh)
    : n_vertices_(mesh.positions.size()), n_faces_(mesh.polygons.size()) {
  require_room(0);
  positions_ = make_big_array<Point3>(n_vertices_);
  std::copy(mesh.positions.begin(), mesh.positions.end(), positions_.get());
  corners_ = make_big_array<Index>(3 * n_faces_);
  for (std::size_t f = 0; f < n_faces_; ++f) {
    const auto& polygon = mesh.polygons[f];
    if (polygon.size() != 3) {
      refuse("face f" + std::to_string(f) + " has " + std::to_string(polygon.size()) +
             " corners");
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (polygon[k] >= n_vertices_ || polygon[k] == polygon[(k + 1) % 3]) {
        refuse("face f" + std::to_string(f) + " has a repeated or missing corner v" +
               std::to_string(polygon[k]));
      }
      corners_[3 * f + k] = polygon[k];
    }
  }
  const std::vector<Index> twins = find_twins(corners_.get(), 3 * n_faces_, n_vertices_);
  number_edges(twins);
  check_fans(twins);
}

void DirectLoop::number_edges(const std::vector<Index>& twins) {
  const std::size_t n_corners = 3 * n_faces_;
  edges_ = make_big_array<Index>(n_corners);
  for (std::size_t h = 0; h < n_corners; ++h) {
    if (twins[h] != kNone) continue;
    edges_[h] = static_cast<Index>(boundary_edges_.size());
    boundary_edges_.push_back({corners_[h], corners_[next_corner(h)]});
  }
  n_edges_ = boundary_edges_.size();
  for (std::size_t h = 0; h < n_corners; ++h) {
    if (twins[h] == kNone || twins[h] < h) continue;
    edges_[h] = static_cast<Index>(n_edges_);
    edges_[twins[h]] = static_cast<Index>(n_edges_);
    ++n_edges_;
  }
}

/// Walks around every vertex and compares with the number of its faces.
void DirectLoop::check_fans(const std::vector<Index>& twins) {
  std::vector<Index> n_faces_at(n_vertices_, 0);
  std::vector<Index> start(n_vertices_, kNone);
  for (std::size_t h = 0; h < 3 * n_faces_; ++h) {
    const Index v = corners_[h];
    ++n_faces_at[v];
    // On a boundary, start where the walk can see the whole fan.
    if (start[v] == kNone || twins[h] == kNone) start[v] = static_cast<Index>(h);
  }
  first_valence_ = n_faces_at;
  for (std::size_t v = 0; v < n_vertices_; ++v) {
    if (start[v] == kNone) refuse("vertex v" + std::to_string(v) + " belongs to no face");
    Index n_seen = 0;
    std::size_t h = start[v];
    do {
      ++n_seen;
      h = twins[previous_corner(h)];
    } while (h != kNone && h != start[v]);
    if (n_seen != n_faces_at[v]) {
      refuse("the faces at vertex v" + std::to_string(v) + " form more than one fan (" +
             std::to_string(n_seen) + " of " + std::to_string(n_faces_at[v]) +
             " faces hang together)");
    }
    if (h == kNone) first_valence_[v] = n_seen == 1 ? kCornerOfOneFace : kBoundary;
  }
}

void DirectLoop::require_room(unsigned levels) const {
  // E <= 3F, so that corners bound everything but a soup's vertices.
  std::uint64_t n_corners = 3 * std::uint64_t{n_faces_};
  constexpr std::uint64_t kMost = kNone;
  for (unsigned level = 0; level < levels && n_corners <= kMost; ++level)
    n_corners *= 4;
  if (n_corners > kMost || n_vertices_ > kMost) {
    throw LoopError(std::to_string(levels) + " levels of " + std::to_string(n_faces_) +
                    " faces are more than the " + std::to_string(kMost / 3) +
                    " faces that fit; take fewer levels");
  }
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

/// What was scattered to the boundary is of no use: its points have rules of their own.
void DirectLoop::finish_boundary(Point3* new_positions,
                                 const DirectLoopOptions& options) const {
  for (const auto& [a, b] : boundary_edges_) {
    new_positions[a] = {};
    new_positions[b] = {};
  }
  for (std::size_t e = 0; e < boundary_edges_.size(); ++e) {
    const auto [a, b] = boundary_edges_[e];
    add(new_positions[a], positions_[b]);
    add(new_positions[b], positions_[a]);
    Point3& point = new_positions[n_vertices_ + e];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[axis] = (positions_[a][axis] + positions_[b][axis]) / 2;
    }
  }
  const auto smooth = [&](std::size_t v) {
    blend(new_positions[v], positions_[v], 3.0 / 4.0, 1.0 / 8.0);
  };
  for (std::size_t v = 0; v < first_valence_.size(); ++v) {
    const bool is_corner = first_valence_[v] == kCornerOfOneFace;
    if (is_corner && options.corner_rule == CornerRule::kCorner) {
      new_positions[v] = positions_[v];
    } else if (is_corner || first_valence_[v] == kBoundary) {
      smooth(v);
    }
  }
  for (const VertexRange& range : later_vertices_) {
    for (std::size_t v = range.begin; v < range.end_of_boundary; ++v)
      smooth(v);
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

void DirectLoop::split_boundary_edges() {
  std::vector<std::array<Index, 2>> halves(2 * boundary_edges_.size());
  for (std::size_t e = 0; e < boundary_edges_.size(); ++e) {
    const auto [a, b] = boundary_edges_[e];
    const auto point = static_cast<Index>(n_vertices_ + e);
    halves[2 * e] = {std::min(a, b), point};
    halves[2 * e + 1] = {point, std::max(a, b)};
  }
  boundary_edges_ = std::move(halves);
}

void DirectLoop::subdivide_once(const DirectLoopOptions& options, double done, double share) {
  auto new_positions = make_big_array<Point3>(n_vertices_ + n_edges_);
  auto new_corners = make_big_array<Index>(12 * n_faces_);
  auto new_edges = make_big_array<Index>(12 * n_faces_);

  // The two scattering passes must each run in the order of the faces, for equal rounding; they
  // go first, and whoever is free splits faces.
  const std::size_t n_chunks = (n_faces_ + kChunk - 1) / kChunk;
  const auto work = [&](std::size_t task) {
    if (task == 0) {
      scatter_edge_points(new_positions.get() + n_vertices_);
    } else if (task == 1) {
      scatter_neighbour_sums(new_positions.get());
      finish_interior(new_positions.get(), options.vertex_rule);
    } else {
      const std::size_t begin = (task - 2) * kChunk;
      split_faces(begin, std::min(begin + kChunk, n_faces_), new_corners.get(),
                  new_edges.get());
    }
  };
  const auto after = [&](std::size_t n_begun) {
    const double part = static_cast<double>(n_begun) / static_cast<double>(n_chunks + 2);
    if (options.progress) options.progress(done + share * part);
  };
  run_parallel(n_chunks > 1 ? options.threads : 1, n_chunks + 2, work, after);
  finish_boundary(new_positions.get(), options);

  later_vertices_.push_back(
      {n_vertices_, n_vertices_ + boundary_edges_.size(), n_vertices_ + n_edges_});
  split_boundary_edges();
  positions_ = std::move(new_positions);
  corners_ = std::move(new_corners);
  edges_ = std::move(new_edges);
  n_vertices_ += n_edges_;
  n_edges_ = 2 * n_edges_ + 3 * n_faces_;
  n_faces_ *= 4;
}

void DirectLoop::subdivide(const DirectLoopOptions& options) {
  require_room(options.levels);
  double whole = 0;
  double level_share = 1;
  for (unsigned level = 0; level < options.levels; ++level, level_share *= 4) {
    whole += level_share;
  }
  double done = 0;
  level_share = 1;
  for (unsigned level = 0; level < options.levels; ++level, level_share *= 4) {
    subdivide_once(options, done / whole, level_share / whole);
    done += level_share;
  }
}

PolygonMesh DirectLoop::polygon_mesh() const {
  PolygonMesh mesh;
  mesh.positions.assign(positions_.get(), positions_.get() + n_vertices_);
  mesh.polygons.reserve(n_faces_);
  for (std::size_t f = 0; f < n_faces_; ++f) {
    mesh.polygons.emplace_back(corners_.get() + 3 * f, corners_.get() + 3 * f + 3);
  }
  return mesh;
}

PolygonMesh direct_loop(const PolygonMesh& mesh, const DirectLoopOptions& options) {
  DirectLoop surface(mesh);
  surface.subdivide(options);
  return surface.polygon_mesh();
}

}  // namespace meshgrade
