#include "grader/judge/triangle_surface.h"

#include <numeric>
#include <vector>

#include "grader/base/text.h"
#include "grader/judge/findings.h"
#include "grader/mesh/mesh_rules.h"
#include "grader/operations/picked_element.h"

namespace meshgrade {
namespace {

/// How many parts a mesh has that no edge joins.
std::size_t count_parts(const MeshDump& mesh) {
  std::vector<Ref> above(mesh.vertices.size());
  std::iota(above.begin(), above.end(), 0U);
  const auto root_of = [&](Ref v) {
    while (above[v] != v)
      v = above[v] = above[above[v]];
    return v;
  };
  for (const HalfedgeRecord& h : mesh.halfedges) {
    if (h.live != 0) above[root_of(h.vertex)] = root_of(mesh.halfedges[h.twin].vertex);
  }
  std::size_t parts = 0;
  for (Ref v = 0; v < above.size(); ++v)
    parts += mesh.vertices[v].live != 0 && above[v] == v ? 1 : 0;
  return parts;
}

}  // namespace

std::optional<Finding> find_other_face(const MeshDump& mesh, const std::string& look_at) {
  for (Ref f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.faces[f].live == 0) continue;
    const std::size_t n = corners_of(mesh, ElementKind::kFace, f).corners.size();
    if (n == 3) continue;
    return make_finding("triangles", "every face is still a triangle", "", face_name(f),
                        face_name(f) + " has 3 corners",
                        face_name(f) + " has " + std::to_string(n), look_at);
  }
  return std::nullopt;
}

std::string topology_text(const MeshDump& mesh) {
  const Counts n = count(mesh);
  const auto euler = static_cast<long>(n.vertices + n.faces) - static_cast<long>(n.edges);
  return plural(count_parts(mesh), "part") + ", " + plural(n.boundaries, "boundary loop") +
         ", V - E + F = " + std::to_string(euler);
}

std::string edge_text(const std::pair<Ref, Ref>& ends) {
  return vertex_name(ends.first) + "-" + vertex_name(ends.second);
}

}  // namespace meshgrade
