#include "grader/judge/operation_surface.h"

#include <algorithm>
#include <array>
#include <set>

#include "grader/base/text.h"
#include "grader/judge/findings.h"
#include "grader/mesh/mesh_rules.h"

namespace meshgrade {
namespace {

using Triangle = std::array<Ref, 3>;

/// The corners of all faces, each turned so that the smallest comes first.
std::set<Triangle> triangles(const MeshDump& mesh) {
  std::set<Triangle> result;
  for (const FaceRecord& f : mesh.faces) {
    if (f.live == 0) continue;
    const HalfedgeRecord& x = mesh.halfedges[f.halfedge];
    const HalfedgeRecord& y = mesh.halfedges[x.next];
    Triangle t{x.vertex, y.vertex, mesh.halfedges[y.next].vertex};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.insert(t);
  }
  return result;
}

std::string triangles_text(const std::set<Triangle>& all, const std::set<Triangle>& others) {
  std::vector<std::string> names;
  for (const Triangle& t : all) {
    if (others.count(t) != 0) continue;
    names.push_back(vertex_name(t[0]) + " " + vertex_name(t[1]) + " " + vertex_name(t[2]));
  }
  if (names.size() > 6) names.resize(6);
  return names.empty() ? "none" : join(names, ", ");
}

bool is_fixed(const OperationResult& result, Ref edge) {
  return edge != result.free_edge && edge < result.before.edges.size();
}

/// Half-edges of the expected mesh to begin a component with, those with a known edge first.
std::vector<Ref> starts_of(const OperationResult& result) {
  const auto& halfedges = result.expected.halfedges;
  std::vector<Ref> starts;
  for (bool fixed : {true, false}) {
    for (Ref h = 0; h < halfedges.size(); ++h) {
      if (halfedges[h].live != 0 && is_fixed(result, halfedges[h].edge) == fixed)
        starts.push_back(h);
    }
  }
  return starts;
}

bool keeps_identity(const OperationResult& result, const SurfaceMatch& match) {
  const MeshDump& before = result.before;
  for (Ref v = 0; v < before.vertices.size(); ++v) {
    if (before.vertices[v].live != 0 && match.vertex[v] != v) return false;
  }
  for (Ref e = 0; e < before.edges.size(); ++e) {
    if (before.edges[e].live != 0 && e != result.free_edge && match.edge[e] != e) return false;
  }
  return true;
}

Finding other_faces(const std::set<Triangle>& want, const std::set<Triangle>& have,
                    const std::string& where, const std::string& edge,
                    const std::string& look_at) {
  bool turned = false;
  for (Triangle t : have) {
    std::swap(t[1], t[2]);
    turned = turned || (want.count(t) != 0 && have.count(t) == 0);
  }
  return make_finding(turned ? "orientation" : "surface",
                      turned ? std::string(rule_meaning("orientation"))
                             : "the faces around the edge are those that the operation gives",
                      where, edge, "faces " + triangles_text(want, have),
                      "faces " + triangles_text(have, want), look_at);
}

/// The faces are right, but some old edge is not where it was.
Finding swapped_edges(const OperationResult& result, const std::string& where,
                      const std::string& edge, const std::string& look_at) {
  const std::string meaning = "the other edges stay where they are";
  for (Ref e = 0; e < result.before.edges.size(); ++e) {
    if (result.before.edges[e].live == 0 || e == result.free_edge) continue;
    const std::string want = edge_ends(result.expected, e);
    const std::string have = edge_ends(result.after, e);
    const std::string turned =
        have.substr(have.find('-') + 1) + "-" + have.substr(0, have.find('-'));
    if (want == have || want == turned) continue;
    return make_finding("identity", meaning, where, edge_name(e),
                        edge_name(e) + " joins " + want, edge_name(e) + " joins " + have,
                        look_at);
  }
  return make_finding("identity", meaning, where, edge, "the same edges between the same faces",
                      "edges have changed places", look_at);
}

}  // namespace

std::string edge_ends(const MeshDump& mesh, Ref edge) {
  const HalfedgeRecord& h = mesh.halfedges[mesh.edges[edge].halfedge];
  return vertex_name(h.vertex) + "-" + vertex_name(mesh.halfedges[h.twin].vertex);
}

std::optional<SurfaceMatch> match_operation(const OperationResult& result) {
  const auto candidates = [&](Ref from) {
    const HalfedgeRecord& mine = result.expected.halfedges[from];
    std::vector<Ref> list;
    for (Ref h = 0; h < result.after.halfedges.size(); ++h) {
      const HalfedgeRecord& other = result.after.halfedges[h];
      if (other.live == 0 || other.vertex != mine.vertex) continue;
      if (!is_fixed(result, mine.edge) || other.edge == mine.edge) list.push_back(h);
    }
    return list;
  };
  SurfaceMatch match(result.expected);
  if (!match_surfaces(result.expected, result.after, starts_of(result), candidates, match) ||
      !keeps_identity(result, match)) {
    return std::nullopt;
  }
  return match;
}

Finding surface_finding(const OperationResult& result, const std::string& where, Ref edge) {
  const std::string name = edge_name(edge) + " (" + edge_ends(result.before, edge) + ")";
  const std::string around = "half-edges around " + edge_name(edge);
  const std::set<Triangle> want = triangles(result.expected);
  const std::set<Triangle> have = triangles(result.after);
  return want != have ? other_faces(want, have, where, name, "the .vertex of the " + around)
                      : swapped_edges(result, where, name, "the .edge of the " + around);
}

}  // namespace meshgrade
