#include "grader/cases/mesh_ladder.h"

#include <algorithm>

#include "grader/cases/mesh_shapes.h"

namespace meshgrade {
namespace {

bool has_boundary(const PolygonMesh& mesh) {
  const TriangleSet triangles(mesh);
  const std::vector<VertexPair> edges = triangles.edges();
  return std::any_of(edges.begin(), edges.end(),
                     [&](VertexPair edge) { return triangles.is_boundary(edge); });
}

}  // namespace

std::vector<Rung> smaller_meshes(const CaseMaker& maker, const PolygonMesh& mesh) {
  std::vector<Rung> rungs;
  for (const char* file : {"single_triangle.obj", "two_triangles.obj", "tetrahedron.obj",
                           "fan.obj", "octahedron.off", "cube.obj", "icosahedron.obj"}) {
    PolygonMesh rung = maker.mesh(file);
    if (rung.polygons.size() >= mesh.polygons.size()) continue;
    rungs.push_back({file, std::move(rung)});
  }
  return rungs;
}

std::vector<Rung> smaller_meshes_alike(const CaseMaker& maker, const PolygonMesh& mesh) {
  const bool open = has_boundary(mesh);
  std::vector<Rung> rungs = smaller_meshes(maker, mesh);
  rungs.erase(std::remove_if(rungs.begin(), rungs.end(),
                             [&](const Rung& rung) { return has_boundary(rung.mesh) != open; }),
              rungs.end());
  return rungs;
}

}  // namespace meshgrade
