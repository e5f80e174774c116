#pragma once

// Meshes for cases: from files, made larger, bent, and as sets of triangles that can be flipped
// and split to know which edges a sequence may ask for.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "grader/base/random.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;

/// The same mesh with its vertices in the order in which the polygons first name them, which is
/// the order that a built half-edge mesh has.
PolygonMesh in_build_order(const PolygonMesh& mesh);

/// The same mesh with another vertex first: that with the most neighbours.
PolygonMesh beginning_at_highest_valence(PolygonMesh mesh);

/// The mesh with every position p replaced by `map(p)`.
template <class Map>
PolygonMesh mapped(PolygonMesh mesh, Map map) {
  for (Point3& p : mesh.positions)
    p = map(p);
  return mesh;
}

/// The mesh stretched by (1, 2, 0.5) and with every coordinate moved by at most `amount`, so
/// that no two faces or angles are alike.
PolygonMesh jittered(const PolygonMesh& mesh, double amount, Random& random);

/// Two pyramids with a common base of n corners: two vertices of valence n.
PolygonMesh bipyramid(std::uint32_t n);

/// A tower with a base and a top of n corners and n quads around: the base wider than the top.
PolygonMesh prism(std::uint32_t n);

/// A flat grid of columns x rows unit squares.
PolygonMesh quad_grid(std::uint32_t columns, std::uint32_t rows);

/// The triangles of a mesh, indexed by their directed edges.
class TriangleSet {
 public:
  explicit TriangleSet(const PolygonMesh& mesh);

  /// All edges, each once, the smaller end first.
  std::vector<VertexPair> edges() const;
  bool has_edge(std::uint32_t a, std::uint32_t b) const;
  bool is_boundary(VertexPair edge) const;

  /// The two vertices opposite to an inner edge.
  VertexPair opposite(VertexPair edge) const;

  /// True if the edge lies inside and its flip would join no two vertices that are joined.
  bool can_flip(VertexPair edge) const;

  /// Turns an inner edge. @return where it lies then
  VertexPair flip(VertexPair edge);

  /// Splits any edge. @return the number of the new vertex
  std::uint32_t split(VertexPair edge);

 private:
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void remove(std::uint32_t a, std::uint32_t b);

  std::map<VertexPair, std::uint32_t> third_;  // directed edge -> third corner of its triangle
  std::uint32_t vertices_ = 0;
};

}  // namespace meshgrade
