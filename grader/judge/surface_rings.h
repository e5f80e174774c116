#pragma once

// What lies around each element of a surface, as the rules of subdivision count it.

#include <vector>

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// Everything is numbered as in the dump.
struct SurfaceRings {
  struct OfEdge {
    Ref a = 0;  ///< where its halfedge() starts
    Ref b = 0;
    std::vector<Ref> faces;      ///< of the surface, that of its halfedge() first: two, or
                                 ///< one on a boundary
    std::vector<Ref> loop = {};  ///< on a boundary the corners of the boundary loop, else none
    bool is_boundary() const { return faces.size() < 2; }
    Ref other(Ref end) const { return end == a ? b : a; }
  };
  struct OfVertex {
    std::vector<Ref> edges;
    std::vector<Ref> faces;  ///< of the surface
    bool is_boundary() const { return faces.size() < edges.size(); }
  };

  std::vector<Point3> positions;
  std::vector<std::vector<Ref>> corners;  ///< of each face, from the start of its halfedge()
  std::vector<OfEdge> edges;
  std::vector<OfVertex> vertices;
};

/// @param mesh  keeps all mesh rules, and all its elements are live
SurfaceRings rings_of(const MeshDump& mesh);

}  // namespace meshgrade
