#include "grader/simplify/openmesh_decimation.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
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

}  // namespace

PolygonMesh openmesh_decimation(const PolygonMesh& mesh, std::size_t faces,
                                const std::function<void(std::size_t)>& progress) {
  DecimatedMesh built = to_openmesh(mesh);
  OpenMesh::Decimater::DecimaterT<DecimatedMesh> decimater(built);
  OpenMesh::Decimater::ModQuadricT<DecimatedMesh>::Handle quadrics;
  decimater.add(quadrics);
  decimater.module(quadrics).unset_max_err();
  Told told(progress);
  decimater.set_observer(&told);
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
  built.garbage_collection();
  return from_openmesh(built);
}

}  // namespace meshgrade
