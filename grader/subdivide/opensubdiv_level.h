#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grader/mesh/polygon_mesh.h"
#include "grader/subdivide/loop_rules.h"

namespace meshgrade {

/// One level of subdivision and where its vertices come from. The children of the old vertices,
/// of the edges, and of the faces together are all vertices of `mesh`, each once.
struct SubdivisionLevel {
  PolygonMesh mesh;
  /// Old vertex -> the vertex of `mesh` that replaces it.
  std::vector<std::uint32_t> child_of_vertex;
  /// The end points of each old edge, in OpenSubdiv's order of edges and of ends.
  std::vector<std::array<std::uint32_t, 2>> edges;
  /// Old edge (an index into `edges`) -> the vertex of `mesh` that splits it.
  std::vector<std::uint32_t> child_of_edge;
  /// Old face -> the vertex of `mesh` in its middle. Empty for Loop, which has none.
  std::vector<std::uint32_t> child_of_face;
};

/// The oracle: one level by OpenSubdiv, in double. Boundary vertices take 3/4, 1/8, 1/8 and
/// boundary edges the midpoint. Warren's vertices are derived from OpenSubdiv's own point P'
/// as P + (b_warren / b_loop) (P' - P). Further levels: call again with the result.
///
/// Takes a valid triangle mesh: a manifold without unused vertices. Throws SubdivisionError if
/// a polygon is not a triangle or if OpenSubdiv refuses the topology.
SubdivisionLevel opensubdiv_loop(const PolygonMesh& mesh, VertexRule vertex_rule,
                                 CornerRule corner_rule);

/// One level of Catmull-Clark subdivision by OpenSubdiv, in double: its usual weights, also for
/// triangles. Boundaries are treated as by opensubdiv_loop().
///
/// Takes a valid mesh: a manifold without unused vertices and without two edges of the same
/// ends. Throws SubdivisionError if OpenSubdiv refuses the topology.
SubdivisionLevel opensubdiv_catmull_clark(const PolygonMesh& mesh, CornerRule corner_rule);

/// The same without smoothing: OpenSubdiv's bilinear scheme.
SubdivisionLevel opensubdiv_bilinear(const PolygonMesh& mesh);

}  // namespace meshgrade
