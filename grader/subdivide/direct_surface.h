#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "grader/mesh/polygon_mesh.h"
#include "grader/subdivide/big_array.h"
#include "grader/subdivide/subdivision_rules.h"

namespace meshgrade {

/// A large surface that is subdivided directly by index: what Loop and Catmull-Clark share.
///
/// No half-edge records are kept: a face is its corners and the ids of its edges. Edge k of a
/// face joins its corners k and k + 1. That is enough, because the children can be numbered by
/// arithmetic:
///   - vertex v stays v; the point of edge e becomes vertex V + e;
///   - edge e becomes 2e (at its end with the lower number) and 2e + 1.
/// Boundary edges come first, so that edge e is on the boundary if and only if e < B, on every
/// level.
class DirectSurface {
 public:
  virtual ~DirectSurface() = default;
  DirectSurface(const DirectSurface&) = delete;
  DirectSurface& operator=(const DirectSurface&) = delete;

  /// Throws SubdivisionError, before anything is allocated, if the result has more than 2^32 -
  /// 1 corners or edges.
  void subdivide(const SubdivisionOptions& options);

  std::size_t n_vertices() const { return n_vertices_; }
  std::size_t n_edges() const { return n_edges_; }
  std::size_t n_faces() const { return n_faces_; }
  /// How many faces `levels` levels would make.
  virtual std::size_t n_faces_after(unsigned levels) const = 0;
  PolygonMesh polygon_mesh() const;

 protected:
  using Index = std::uint32_t;

  /// Marks in first_valence_, which is 2 or more inside.
  static constexpr Index kBoundary = 0;
  static constexpr Index kCornerOfOneFace = 1;

  /// Vertices that were made in one level: boundary ones first.
  struct VertexRange {
    std::size_t begin;
    std::size_t end_of_boundary;
    std::size_t end;
  };

  /// Takes a manifold, closed or with boundary.
  /// @param corners_later  of each face after the first level
  /// @param needs          ends every message: "Loop subdivision needs a manifold of triangles"
  /// Throws SubdivisionError and names the face, edge or vertex if there is a repeated or
  /// missing corner, an edge with more than two faces or run twice in one direction, a vertex
  /// whose faces do not form one fan, or a vertex without faces.
  DirectSurface(const PolygonMesh& mesh, std::size_t corners_later, const std::string& needs);

  /// One level: new positions, corners, edges, and all numbers. It is `share` of the whole
  /// work, of which `done` is done.
  virtual void subdivide_once(const SubdivisionOptions& options, double done, double share) = 0;

  struct Level {
    BigArray<Point3> positions;
    BigArray<Index> corners;
    BigArray<Index> edges;
  };

  /// Two passes over all faces, each in their order, for equal rounding, and `split` for a
  /// range of faces at a time: side by side.
  void share_work(const SubdivisionOptions& options, double done, double share,
                  const std::function<void()>& one_pass,
                  const std::function<void()>& other_pass,
                  const std::function<void(std::size_t begin, std::size_t end)>& split) const;
  /// Goes on with what was made. Its edges and corners follow from those that there are.
  void take(Level level, std::size_t n_vertices, std::size_t n_faces);

  std::size_t n_corners() const;

  /// The points of boundary edges and the boundary vertices: a cubic spline of its own. What
  /// was scattered to them before is of no use.
  void finish_boundary(Point3* new_positions, const SubdivisionOptions& options) const;

  std::size_t n_vertices_ = 0;
  std::size_t n_edges_ = 0;
  std::size_t n_faces_ = 0;
  BigArray<Point3> positions_;
  BigArray<Index> corners_;  // of all faces, one face after the other
  BigArray<Index> edges_;    // edges_[c] leads from corner c to the next one of its face
  /// The first corner of each face and the end, as long as faces may differ; then empty.
  std::vector<Index> first_corner_;
  /// The ends of the boundary edges.
  std::vector<std::array<Index, 2>> boundary_edges_;
  /// For the vertices of the first mesh, and those after them whose valence may be any: it, or
  /// one of the marks.
  std::vector<Index> first_valence_;
  /// The vertices that came later: they are regular or lie on a smooth boundary.
  std::vector<VertexRange> later_vertices_;

 private:
  void split_boundary_edges();
  void require_room(unsigned levels) const;
  void take_corners(const PolygonMesh& mesh);
  void index_topology();

  std::size_t corners_later_;
  std::string needs_;
};

inline void add(Point3& sum, const Point3& term) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    sum[axis] += term[axis];
}

/// keep * old + weight * sum, into sum.
inline void blend(Point3& sum, const Point3& old, double keep, double weight) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    sum[axis] = keep * old[axis] + weight * sum[axis];
}

}  // namespace meshgrade
