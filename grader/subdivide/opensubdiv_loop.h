#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grader/mesh/polygon_mesh.h"
#include "grader/subdivide/loop_rules.h"

namespace meshgrade {

/// One level of Loop subdivision and where its vertices come from. The children of the old
/// vertices and of the edges together are all vertices of `mesh`, each once.
struct LoopLevel {
  PolygonMesh mesh;
  /// Old vertex -> the vertex of `mesh` that replaces it.
  std::vector<std::uint32_t> child_of_vertex;
  /// The end points of each old edge, in OpenSubdiv's order of edges and of ends.
  std::vector<std::array<std::uint32_t, 2>> edges;
  /// Old edge (an index into `edges`) -> the vertex of `mesh` that splits it.
  std::vector<std::uint32_t> child_of_edge;
};

/// The oracle: one level by OpenSubdiv, in double. Boundary vertices take 3/4, 1/8, 1/8 and
/// boundary edges the midpoint. Warren's vertices are derived from OpenSubdiv's own point P'
/// as P + (b_warren / b_loop) (P' - P). Further levels: call again with the result.
///
/// Takes a valid triangle mesh: a manifold without unused vertices. Throws LoopError if a
/// polygon is not a triangle or if OpenSubdiv refuses the topology.
LoopLevel opensubdiv_loop(const PolygonMesh& mesh, VertexRule vertex_rule,
                          CornerRule corner_rule);

}  // namespace meshgrade
