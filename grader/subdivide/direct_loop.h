#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "grader/mesh/polygon_mesh.h"
#include "grader/subdivide/big_array.h"
#include "grader/subdivide/loop_rules.h"

namespace meshgrade {

struct DirectLoopOptions {
  VertexRule vertex_rule = VertexRule::kLoop;
  CornerRule corner_rule = CornerRule::kSmooth;
  unsigned levels = 1;
  /// The result is the same to the last bit for every number of threads.
  unsigned threads = 1;
  /// Called now and then, in the calling thread, with the part that is done: 0 to 1.
  std::function<void(double)> progress;
};

/// Loop subdivision of large triangle meshes, directly by index.
///
/// No half-edge records are kept: a triangle is three vertices and the ids of its three edges.
/// That is enough, because the children can be numbered by arithmetic:
///   - vertex v stays v; the point of edge e becomes vertex V + e;
///   - face f becomes 4f, 4f + 1, 4f + 2 (at its corners) and 4f + 3 (in the middle);
///   - edge e becomes 2e (at its end with the lower number) and 2e + 1; the edge in face f that
///     joins the points of its edges k and k + 1 becomes 2E + 3f + k.
/// Boundary edges come first, so that edge e is on the boundary if and only if e < B, on every
/// level. Neighbour sums are scattered into the new positions in one pass over the faces.
class DirectLoop {
 public:
  /// Takes a manifold of triangles, closed or with boundary. Throws LoopError and names the
  /// face, edge or vertex if there is a polygon of another size, an edge with more than two
  /// faces or run twice in one direction, a vertex whose faces do not form one fan, or a vertex
  /// without faces.
  explicit DirectLoop(const PolygonMesh& mesh);

  /// Throws LoopError, before anything is allocated, if the result has more than 2^32 - 1
  /// corners or edges.
  void subdivide(const DirectLoopOptions& options);

  std::size_t n_vertices() const { return n_vertices_; }
  std::size_t n_edges() const { return n_edges_; }
  std::size_t n_faces() const { return n_faces_; }
  PolygonMesh polygon_mesh() const;

 private:
  using Index = std::uint32_t;

  /// Vertices that were made in one level: boundary ones first.
  struct VertexRange {
    std::size_t begin;
    std::size_t end_of_boundary;
    std::size_t end;
  };

  void number_edges(const std::vector<Index>& twins);
  void check_fans(const std::vector<Index>& twins);
  void require_room(unsigned levels) const;
  void subdivide_once(const DirectLoopOptions& options, double done, double share);
  void scatter_edge_points(Point3* edge_points) const;
  void scatter_neighbour_sums(Point3* sums) const;
  void split_faces(std::size_t begin, std::size_t end, Index* corners, Index* edges) const;
  void finish_boundary(Point3* new_positions, const DirectLoopOptions& options) const;
  void finish_interior(Point3* new_positions, VertexRule rule) const;
  void split_boundary_edges();

  std::size_t n_vertices_ = 0;
  std::size_t n_edges_ = 0;
  std::size_t n_faces_ = 0;
  BigArray<Point3> positions_;
  BigArray<Index> corners_;  // of face f: 3f, 3f + 1, 3f + 2
  BigArray<Index> edges_;    // 3f + k joins corners k and k + 1
  /// The ends of the boundary edges.
  std::vector<std::array<Index, 2>> boundary_edges_;
  /// For the vertices of the first mesh: the valence, or one of the marks of direct_loop.cpp.
  std::vector<Index> first_valence_;
  /// The vertices that came later: they have valence 6 or lie on a smooth boundary.
  std::vector<VertexRange> later_vertices_;
};

/// `options.levels` levels of Loop subdivision. See DirectLoop for what is taken and thrown.
PolygonMesh direct_loop(const PolygonMesh& mesh, const DirectLoopOptions& options);

}  // namespace meshgrade
