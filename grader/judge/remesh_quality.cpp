#include "grader/judge/remesh_quality.h"

#include <cmath>

#include "grader/judge/point_compare.h"

namespace meshgrade {
MeshQuality quality_of(const MeshDump& mesh) {
  std::vector<double> lengths;
  std::vector<int> valences(mesh.vertices.size(), 0);
  for (const EdgeRecord& e : mesh.edges) {
    if (e.live == 0) continue;
    const Ref a = mesh.halfedges[e.halfedge].vertex;
    const Ref b = mesh.halfedges[mesh.halfedges[e.halfedge].twin].vertex;
    lengths.push_back(distance(mesh.vertices[a].position, mesh.vertices[b].position));
    ++valences[a];
    ++valences[b];
  }
  MeshQuality quality;
  const auto n = static_cast<double>(lengths.size());
  for (const double length : lengths)
    quality.mean_length += length / n;
  double squares = 0.0;
  for (const double length : lengths)
    squares += std::pow(length - quality.mean_length, 2) / n;
  quality.variation = std::sqrt(squares) / quality.mean_length;
  double vertices = 0.0;
  for (Ref v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].live == 0) continue;
    vertices += 1.0;
    quality.deviation += std::abs(valences[v] - 6);
  }
  quality.deviation /= vertices;
  return quality;
}

}  // namespace meshgrade
