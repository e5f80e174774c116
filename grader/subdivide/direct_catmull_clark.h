#pragma once

#include "grader/subdivide/direct_surface.h"

namespace meshgrade {

/// Catmull-Clark subdivision of large meshes of any polygons, directly by index. The point of
/// face f becomes vertex V + E + f. Corner c of the whole mesh becomes face c, a quadrilateral
/// that begins at its old vertex; the edge from the point of edge c to the middle of the face
/// becomes 2E + c.
///
/// Rules of Catmull and Clark (1978): a face point is the mean of the corners, an edge point
/// the mean of its ends and of the two face points beside it, and an inner vertex of valence n
/// moves to (n - 2) / n v + (the sum of its neighbours and of the face points around it) / n^2.
/// A boundary is a cubic spline of its own.
class DirectCatmullClark : public DirectSurface {
 public:
  /// Takes a manifold of polygons; see DirectSurface for what is thrown.
  explicit DirectCatmullClark(const PolygonMesh& mesh);

  std::size_t n_faces_after(unsigned levels) const override;

 private:
  void subdivide_once(const SubdivisionOptions& options, double done, double share) override;
  template <class Visit>
  void visit_faces(std::size_t begin, std::size_t end, Visit visit) const;
  Point3 face_point(std::size_t begin, std::size_t end) const;
  void scatter_points(Point3* edge_points, Point3* face_points) const;
  void scatter_neighbour_sums(Point3* sums) const;
  void split_faces(std::size_t begin, std::size_t end, Index* corners, Index* edges) const;
  void finish_interior(Point3* new_positions) const;
  void note_new_vertices();
};

/// `options.levels` levels of Catmull-Clark subdivision. See DirectCatmullClark for what is
/// taken and thrown.
PolygonMesh direct_catmull_clark(const PolygonMesh& mesh, const SubdivisionOptions& options);

}  // namespace meshgrade
