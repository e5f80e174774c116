#pragma once

// The next level of a subdivision into quads, without half-edges. C++17: used by the worker and
// by the judge, which must number it alike.

#include <cstdint>
#include <vector>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// A position for each vertex, edge and face of a mesh, by its number.
struct RefinedPoints {
  std::vector<Point3> vertices;
  std::vector<Point3> edges;
  std::vector<Point3> faces;
};

/// Cuts each face with n corners into n quads, one at each corner, as Catmull and Clark do:
/// from the corner over the point of the side that starts there and that of the face to the
/// point of the side before. Vertex i stays i, the point of edge i becomes V + i, and that of
/// face i becomes V + E + i.
///
/// @param old     keeps all mesh rules, and all its elements are live
/// @param points  one for each of them
inline PolygonMesh refined_mesh(const MeshDump& old, const RefinedPoints& points) {
  PolygonMesh refined;
  for (const auto* some : {&points.vertices, &points.edges, &points.faces})
    refined.positions.insert(refined.positions.end(), some->begin(), some->end());
  const auto first_edge = static_cast<std::uint32_t>(points.vertices.size());
  const auto first_face = first_edge + static_cast<std::uint32_t>(points.edges.size());
  for (Ref f = 0; f < old.faces.size(); ++f) {
    Ref before = old.faces[f].halfedge;
    Ref h = old.halfedges[before].next;
    const Ref end = h;
    do {
      const HalfedgeRecord& side = old.halfedges[h];
      refined.polygons.push_back({side.vertex, first_edge + side.edge, first_face + f,
                                  first_edge + old.halfedges[before].edge});
      before = h;
      h = side.next;
    } while (h != end);
  }
  return refined;
}

}  // namespace meshgrade
