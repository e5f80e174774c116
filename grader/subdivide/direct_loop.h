#pragma once

#include "grader/subdivide/direct_surface.h"

namespace meshgrade {

/// Loop subdivision of large triangle meshes, directly by index. Face f becomes 4f, 4f + 1,
/// 4f + 2 (at its corners) and 4f + 3 (in the middle); the edge in face f that joins the points
/// of its edges k and k + 1 becomes 2E + 3f + k. Neighbour sums are scattered into the new
/// positions in one pass over the faces.
class DirectLoop : public DirectSurface {
 public:
  /// Takes a manifold of triangles; see DirectSurface for what is thrown.
  explicit DirectLoop(const PolygonMesh& mesh);

  std::size_t n_faces_after(unsigned levels) const override;

 private:
  void subdivide_once(const SubdivisionOptions& options, double done, double share) override;
  void scatter_edge_points(Point3* edge_points) const;
  void scatter_neighbour_sums(Point3* sums) const;
  void split_faces(std::size_t begin, std::size_t end, Index* corners, Index* edges) const;
  void finish_interior(Point3* new_positions, VertexRule rule) const;
};

/// `options.levels` levels of Loop subdivision. See DirectLoop for what is taken and thrown.
PolygonMesh direct_loop(const PolygonMesh& mesh, const SubdivisionOptions& options);

}  // namespace meshgrade
