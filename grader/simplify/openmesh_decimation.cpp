#include "grader/simplify/openmesh_decimation.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>

namespace meshgrade {
namespace {

struct InDouble : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

using DecimatedMesh = OpenMesh::TriMesh_ArrayKernelT<InDouble>;

class Told : public OpenMesh::Decimater::Observer {
 public:
  explicit Told(const std::function<void(std::size_t)>& progress)
      : Observer(kCollapsesBetween), progress_(progress) {}
  void notify(std::size_t collapses) override {
    if (progress_) progress_(collapses);
  }

 private:
  static constexpr std::size_t kCollapsesBetween = 1000;
  const std::function<void(std::size_t)>& progress_;
};

DecimatedMesh to_openmesh(const PolygonMesh& mesh) {
  DecimatedMesh built;
  std::vector<OpenMesh::VertexHandle> vertices;
  for (const Point3& p : mesh.positions)
    vertices.push_back(built.add_vertex({p[0], p[1], p[2]}));
  for (const auto& polygon : mesh.polygons)
    built.add_face(vertices[polygon[0]], vertices[polygon[1]], vertices[polygon[2]]);
  return built;
}

PolygonMesh from_openmesh(const DecimatedMesh& built) {
  PolygonMesh mesh;
  for (const auto v : built.vertices()) {
    const auto& p = built.point(v);
    mesh.positions.push_back({p[0], p[1], p[2]});
  }
  for (const auto f : built.faces()) {
    mesh.polygons.emplace_back();
    for (const auto v : built.fv_range(f))
      mesh.polygons.back().push_back(static_cast<std::uint32_t>(v.idx()));
  }
  return mesh;
}

using Decimater = OpenMesh::Decimater::DecimaterT<DecimatedMesh>;

/// Lets a boundary vertex go only where its boundary runs straight on, along the boundary.
template <class MeshT>
class ModOutlineT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModOutlineT, MeshT, Outline);
  explicit ModOutlineT(MeshT& mesh) : Base(mesh, true) {}

  float collapse_priority(const CollapseInfo& collapse) override {
    MeshT& mesh = Base::mesh();
    if (!mesh.is_boundary(collapse.v0)) return Base::LEGAL_COLLAPSE;
    if (!mesh.is_boundary(mesh.edge_handle(collapse.v0v1))) return Base::ILLEGAL_COLLAPSE;
    const auto out = mesh.halfedge_handle(collapse.v0);  // that of a boundary vertex is outside
    const auto& next = mesh.point(mesh.to_vertex_handle(out));
    const auto& last = mesh.point(mesh.from_vertex_handle(mesh.prev_halfedge_handle(out)));
    const auto way = next - last;
    const auto here = collapse.p0 - last;
    const double along = here | way;
    const bool lies_between = along > 0.0 && along < way.sqrnorm();
    const bool is_straight = (here % way).norm() <= kStraight * way.sqrnorm();
    return lies_between && is_straight ? Base::LEGAL_COLLAPSE : Base::ILLEGAL_COLLAPSE;
  }

 private:
  static constexpr double kStraight = 1e-6;  ///< the offset, by the distance of the neighbours
};

void add_quadrics(Decimater& decimater) {
  OpenMesh::Decimater::ModQuadricT<DecimatedMesh>::Handle quadrics;
  decimater.add(quadrics);
  decimater.module(quadrics).unset_max_err();
}

PolygonMesh decimated(DecimatedMesh& built, Decimater& decimater, std::size_t faces) {
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
  built.garbage_collection();
  return from_openmesh(built);
}

}  // namespace

PolygonMesh openmesh_decimation(const PolygonMesh& mesh, std::size_t faces) {
  DecimatedMesh built = to_openmesh(mesh);
  Decimater decimater(built);
  add_quadrics(decimater);
  return decimated(built, decimater, faces);
}

PolygonMesh outline_keeping_decimation(const PolygonMesh& mesh, std::size_t faces,
                                       const std::function<void(std::size_t)>& progress) {
  constexpr float kMostTurned = 80.0F;  // degrees
  DecimatedMesh built = to_openmesh(mesh);
  built.request_face_normals();
  built.update_face_normals();
  Decimater decimater(built);
  add_quadrics(decimater);
  OpenMesh::Decimater::ModNormalFlippingT<DecimatedMesh>::Handle flips;
  decimater.add(flips);
  decimater.module(flips).set_max_normal_deviation(kMostTurned);
  ModOutlineT<DecimatedMesh>::Handle outline;
  decimater.add(outline);
  Told told(progress);
  decimater.set_observer(&told);
  return decimated(built, decimater, faces);
}

}  // namespace meshgrade
