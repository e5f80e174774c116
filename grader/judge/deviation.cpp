#include "grader/judge/deviation.h"

#include <algorithm>
#include <cmath>

#include "grader/judge/point_compare.h"

namespace meshgrade {

Deviation measure_deviation(const std::vector<Point3>& expected, const MeshDump& mesh,
                            const std::vector<Ref>& match, double size, double allowed) {
  Deviation deviation;
  deviation.allowed = allowed;
  deviation.of_vertex.assign(mesh.vertices.size(), NAN);
  for (std::size_t v = 0; v < expected.size(); ++v) {
    const double off = distance(expected[v], mesh.vertices[match[v]].position) / size;
    deviation.of_vertex[match[v]] = off;
    deviation.largest = std::max(deviation.largest, off);
    if (!(off <= allowed)) deviation.worst.push_back(match[v]);
  }
  std::stable_sort(deviation.worst.begin(), deviation.worst.end(), [&](Ref a, Ref b) {
    return deviation.of_vertex[a] > deviation.of_vertex[b];
  });
  return deviation;
}

}  // namespace meshgrade
