#include "grader/simplify/openmesh_decimation.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace meshgrade {
namespace {

struct InDouble : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

using DecimatedMesh = OpenMesh::TriMesh_ArrayKernelT<InDouble>;

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

PolygonMesh openmesh_decimation(const PolygonMesh& mesh, std::size_t faces) {
  DecimatedMesh built = to_openmesh(mesh);
  OpenMesh::Decimater::DecimaterT<DecimatedMesh> decimater(built);
  OpenMesh::Decimater::ModQuadricT<DecimatedMesh>::Handle quadrics;
  decimater.add(quadrics);
  decimater.module(quadrics).unset_max_err();
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
  built.garbage_collection();
  return from_openmesh(built);
}

}  // namespace meshgrade
