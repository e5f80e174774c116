#include "grader/cases/mesh_ladder.h"

#include <algorithm>

#include "grader/cases/mesh_shapes.h"

namespace meshgrade {
namespace {

/// Whether every vertex is joined to one on a boundary.
bool is_open(const PolygonMesh& mesh) {
  const TriangleSet triangles(mesh);
  const std::vector<VertexPair> edges = triangles.edges();
  std::vector<bool> reached(mesh.positions.size(), false);
  for (const VertexPair& edge : edges) {
    if (triangles.is_boundary(edge)) reached[edge.first] = reached[edge.second] = true;
  }
  for (bool grows = true; grows;) {
    grows = false;
    for (const auto& [a, b] : edges) {
      if (reached[a] == reached[b]) continue;
      reached[a] = reached[b] = grows = true;
    }
  }
  return std::find(reached.begin(), reached.end(), false) == reached.end();
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
  const bool open = is_open(mesh);
  std::vector<Rung> rungs = smaller_meshes(maker, mesh);
  rungs.erase(std::remove_if(rungs.begin(), rungs.end(),
                             [&](const Rung& rung) { return is_open(rung.mesh) != open; }),
              rungs.end());
  return rungs;
}

}  // namespace meshgrade
