#include "grader/subdivide/direct_surface.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <string>
#include <thread>
#include <utility>

namespace meshgrade {
namespace {

using Index = std::uint32_t;

constexpr Index kNone = std::numeric_limits<Index>::max();

constexpr std::size_t kFacesAtATime = 1U << 11U;  // that one thread splits

std::string edge_between(Index a, Index b) {
  return "the edge from v" + std::to_string(a) + " to v" + std::to_string(b);
}

/// The corners of the first mesh, each with the half-edge that leaves it.
class Corners {
 public:
  Corners(const Index* vertices, const std::vector<Index>& first_corner)
      : vertices_(vertices),
        next_(first_corner.back()),
        previous_(next_.size()),
        face_(next_.size()) {
    for (std::size_t f = 0; f + 1 < first_corner.size(); ++f) {
      const Index begin = first_corner[f];
      const Index end = first_corner[f + 1];
      for (Index c = begin; c < end; ++c) {
        next_[c] = c + 1 == end ? begin : c + 1;
        previous_[next_[c]] = c;
        face_[c] = static_cast<Index>(f);
      }
    }
  }

  std::size_t size() const { return next_.size(); }
  Index start(std::size_t h) const { return vertices_[h]; }
  Index end(std::size_t h) const { return vertices_[next_[h]]; }
  Index previous(std::size_t h) const { return previous_[h]; }
  std::string face_name(std::size_t h) const { return "f" + std::to_string(face_[h]); }

 private:
  const Index* vertices_;
  std::vector<Index> next_;
  std::vector<Index> previous_;
  std::vector<Index> face_;
};

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

EdgeFile file_edges(const Corners& corners, std::size_t n_vertices) {
  EdgeFile file;
  file.begin.assign(n_vertices + 1, 0);
  const auto lower_end = [&](std::size_t h) {
    return std::min(corners.start(h), corners.end(h));
  };
  for (std::size_t h = 0; h < corners.size(); ++h)
    ++file.begin[lower_end(h) + 1];
  for (std::size_t v = 0; v < n_vertices; ++v)
    file.begin[v + 1] += file.begin[v];
  file.filed.resize(corners.size());
  std::vector<Index> next = file.begin;
  for (std::size_t h = 0; h < corners.size(); ++h) {
    const Index higher = std::max(corners.start(h), corners.end(h));
    file.filed[next[lower_end(h)]++] = {higher, static_cast<Index>(h)};
  }
  return file;
}

/// Pairs the half-edges [begin, end), which share their lower end. @return what is wrong; empty
/// if nothing is
std::string pair_edges(FiledEdge* begin, FiledEdge* end, const Corners& corners,
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
      const std::string name = edge_between(corners.start(h), corners.end(h));
      if (stop - at > 2) {
        return name + " has " + std::to_string(stop - at) + " faces (" + corners.face_name(h) +
               ", " + corners.face_name(t) + ", " + corners.face_name(at[2].half_edge) +
               " ...)";
      }
      if (corners.start(h) == corners.start(t)) {
        return name + " is run in the same direction by " + corners.face_name(h) + " and " +
               corners.face_name(t);
      }
      twins[h] = t;
      twins[t] = h;
    }
    at = stop;
  }
  return {};
}

/// @throws SubdivisionError with `needs` at its end
std::vector<Index> find_twins(const Corners& corners, std::size_t n_vertices,
                              const std::string& needs) {
  EdgeFile file = file_edges(corners, n_vertices);
  std::vector<Index> twins(corners.size(), kNone);
  for (std::size_t v = 0; v < n_vertices; ++v) {
    const std::string wrong = pair_edges(file.filed.data() + file.begin[v],
                                         file.filed.data() + file.begin[v + 1], corners, twins);
    if (!wrong.empty()) throw SubdivisionError(wrong + "; " + needs);
  }
  return twins;
}

/// Walks around every vertex and compares with the number of its faces.
/// @return for each vertex its valence, or `boundary`, or `corner` where it has one face only
/// @throws SubdivisionError with `needs` at its end
std::vector<Index> check_fans(const Corners& corners, const std::vector<Index>& twins,
                              std::size_t n_vertices, const std::string& needs, Index boundary,
                              Index corner) {
  std::vector<Index> valence(n_vertices, 0);
  std::vector<Index> start(n_vertices, kNone);
  for (std::size_t h = 0; h < corners.size(); ++h) {
    const Index v = corners.start(h);
    ++valence[v];
    // On a boundary, start where the walk can see the whole fan.
    if (start[v] == kNone || twins[h] == kNone) start[v] = static_cast<Index>(h);
  }
  for (std::size_t v = 0; v < n_vertices; ++v) {
    const std::string name = "vertex v" + std::to_string(v);
    if (start[v] == kNone) throw SubdivisionError(name + " belongs to no face; " + needs);
    Index n_seen = 0;
    std::size_t h = start[v];
    do {
      ++n_seen;
      h = twins[corners.previous(h)];
    } while (h != kNone && h != start[v]);
    if (n_seen != valence[v]) {
      throw SubdivisionError("the faces at " + name + " form more than one fan (" +
                             std::to_string(n_seen) + " of " + std::to_string(valence[v]) +
                             " faces hang together); " + needs);
    }
    if (h == kNone) valence[v] = n_seen == 1 ? corner : boundary;
  }
  return valence;
}

bool repeats_a_corner(std::vector<std::uint32_t> polygon) {
  std::sort(polygon.begin(), polygon.end());
  return std::adjacent_find(polygon.begin(), polygon.end()) != polygon.end();
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

}  // namespace

DirectSurface::DirectSurface(const PolygonMesh& mesh, std::size_t corners_later,
                             const std::string& needs)
    : n_vertices_(mesh.positions.size()),
      n_faces_(mesh.polygons.size()),
      corners_later_(corners_later),
      needs_(needs) {
  first_corner_.push_back(0);
  std::uint64_t n_corners = 0;
  for (const auto& polygon : mesh.polygons) {
    n_corners += polygon.size();
    first_corner_.push_back(static_cast<Index>(std::min<std::uint64_t>(n_corners, kNone)));
  }
  require_room(0);
  positions_ = make_big_array<Point3>(n_vertices_);
  std::copy(mesh.positions.begin(), mesh.positions.end(), positions_.get());
  take_corners(mesh);
  index_topology();
}

void DirectSurface::take_corners(const PolygonMesh& mesh) {
  corners_ = make_big_array<Index>(first_corner_.back());
  for (std::size_t f = 0; f < n_faces_; ++f) {
    const auto& polygon = mesh.polygons[f];
    const bool is_missing =
        std::any_of(polygon.begin(), polygon.end(), [&](Index v) { return v >= n_vertices_; });
    if (polygon.size() < 3 || is_missing || repeats_a_corner(polygon)) {
      throw SubdivisionError("face f" + std::to_string(f) +
                             (polygon.size() < 3 ? " has fewer than three corners; "
                                                 : " has a repeated or missing corner; ") +
                             needs_);
    }
    std::copy(polygon.begin(), polygon.end(), corners_.get() + first_corner_[f]);
  }
}

/// Numbers the edges, those on the boundary first.
void DirectSurface::index_topology() {
  const Corners corners(corners_.get(), first_corner_);
  const std::vector<Index> twins = find_twins(corners, n_vertices_, needs_);
  edges_ = make_big_array<Index>(corners.size());
  for (std::size_t h = 0; h < corners.size(); ++h) {
    if (twins[h] != kNone) continue;
    edges_[h] = static_cast<Index>(boundary_edges_.size());
    boundary_edges_.push_back({corners.start(h), corners.end(h)});
  }
  n_edges_ = boundary_edges_.size();
  for (std::size_t h = 0; h < corners.size(); ++h) {
    if (twins[h] == kNone || twins[h] < h) continue;
    edges_[h] = static_cast<Index>(n_edges_);
    edges_[twins[h]] = static_cast<Index>(n_edges_);
    ++n_edges_;
  }
  first_valence_ = check_fans(corners, twins, n_vertices_, needs_, kBoundary, kCornerOfOneFace);
}

void DirectSurface::require_room(unsigned levels) const {
  // There are no more edges, and after a level no more vertices, than corners.
  std::uint64_t n_later = n_corners();
  constexpr std::uint64_t kMost = kNone;
  for (unsigned level = 0; level < levels && n_later < kMost; ++level)
    n_later *= 4;
  if (n_later >= kMost || n_vertices_ >= kMost) {
    throw SubdivisionError(std::to_string(levels) + " levels of " + std::to_string(n_faces_) +
                           " faces are more than the " +
                           std::to_string(kMost / corners_later_) +
                           " faces that fit; take fewer levels");
  }
}

void DirectSurface::finish_boundary(Point3* new_positions,
                                    const SubdivisionOptions& options) const {
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

void DirectSurface::split_boundary_edges() {
  std::vector<std::array<Index, 2>> halves(2 * boundary_edges_.size());
  for (std::size_t e = 0; e < boundary_edges_.size(); ++e) {
    const auto [a, b] = boundary_edges_[e];
    const auto point = static_cast<Index>(n_vertices_ + e);
    halves[2 * e] = {std::min(a, b), point};
    halves[2 * e + 1] = {point, std::max(a, b)};
  }
  boundary_edges_ = std::move(halves);
}

void DirectSurface::subdivide(const SubdivisionOptions& options) {
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

std::size_t DirectSurface::n_corners() const {
  return first_corner_.empty() ? corners_later_ * n_faces_ : first_corner_.back();
}

void DirectSurface::share_work(
    const SubdivisionOptions& options, double done, double share,
    const std::function<void()>& one_pass, const std::function<void()>& other_pass,
    const std::function<void(std::size_t begin, std::size_t end)>& split) const {
  // The passes go first, and whoever is free splits faces.
  const std::size_t n_chunks = (n_faces_ + kFacesAtATime - 1) / kFacesAtATime;
  const auto work = [&](std::size_t task) {
    if (task == 0) {
      one_pass();
    } else if (task == 1) {
      other_pass();
    } else {
      const std::size_t begin = (task - 2) * kFacesAtATime;
      split(begin, std::min(begin + kFacesAtATime, n_faces_));
    }
  };
  const auto after = [&](std::size_t n_begun) {
    const double part = static_cast<double>(n_begun) / static_cast<double>(n_chunks + 2);
    if (options.progress) options.progress(done + share * part);
  };
  run_parallel(n_chunks > 1 ? options.threads : 1, n_chunks + 2, work, after);
}

void DirectSurface::take(Level level, std::size_t n_vertices, std::size_t n_faces) {
  const std::size_t n_edges = 2 * n_edges_ + n_corners();
  split_boundary_edges();
  positions_ = std::move(level.positions);
  corners_ = std::move(level.corners);
  edges_ = std::move(level.edges);
  first_corner_.clear();
  n_vertices_ = n_vertices;
  n_edges_ = n_edges;
  n_faces_ = n_faces;
}

PolygonMesh DirectSurface::polygon_mesh() const {
  PolygonMesh mesh;
  mesh.positions.assign(positions_.get(), positions_.get() + n_vertices_);
  mesh.polygons.reserve(n_faces_);
  for (std::size_t f = 0; f < n_faces_; ++f) {
    const std::size_t begin = first_corner_.empty() ? corners_later_ * f : first_corner_[f];
    const std::size_t end =
        first_corner_.empty() ? begin + corners_later_ : first_corner_[f + 1];
    mesh.polygons.emplace_back(corners_.get() + begin, corners_.get() + end);
  }
  return mesh;
}

}  // namespace meshgrade
