#include "grader/judge/surface_match.h"

#include <utility>

namespace meshgrade {
namespace {

/// Enters one pair into a map. @return false if the first is mapped to something else already
bool assign(std::vector<Ref>& map, Ref from, Ref to, std::vector<Ref>& entered) {
  if (map[from] == to) return true;
  if (map[from] != kUnsetRef) return false;
  map[from] = to;
  entered.push_back(from);
  return true;
}

class ComponentMatcher {
 public:
  ComponentMatcher(const MeshDump& expected, const MeshDump& actual, SurfaceMatch& match)
      : expected_(expected), actual_(actual), match_(match) {}

  bool run(Ref from, Ref to) {
    if (!pair(from, to)) return undo();
    while (!open_.empty()) {
      const Ref h = open_.back();
      open_.pop_back();
      const HalfedgeRecord& mine = expected_.halfedges[h];
      const HalfedgeRecord& other = actual_.halfedges[match_.halfedge[h]];
      if (!pair(mine.next, other.next) || !pair(mine.twin, other.twin)) return undo();
    }
    return true;
  }

 private:
  bool pair(Ref from, Ref to) {
    if (match_.halfedge[from] == to) return true;
    const HalfedgeRecord& mine = expected_.halfedges[from];
    const HalfedgeRecord& other = actual_.halfedges[to];
    const bool same_side = (mine.face & kBoundaryBit) == (other.face & kBoundaryBit);
    if (!same_side || !assign(match_.halfedge, from, to, halfedges_) ||
        !assign(match_.vertex, mine.vertex, other.vertex, vertices_) ||
        !assign(match_.edge, mine.edge, other.edge, edges_)) {
      return false;
    }
    open_.push_back(from);
    return true;
  }

  bool undo() {
    for (Ref h : halfedges_)
      match_.halfedge[h] = kUnsetRef;
    for (Ref v : vertices_)
      match_.vertex[v] = kUnsetRef;
    for (Ref e : edges_)
      match_.edge[e] = kUnsetRef;
    return false;
  }

  const MeshDump& expected_;
  const MeshDump& actual_;
  SurfaceMatch& match_;
  std::vector<Ref> open_;
  std::vector<Ref> halfedges_;
  std::vector<Ref> vertices_;
  std::vector<Ref> edges_;
};

/// No two elements are mapped to the same one.
bool is_injective(const std::vector<Ref>& map, std::size_t targets) {
  std::vector<bool> taken(targets, false);
  for (Ref to : map) {
    if (to == kUnsetRef) continue;
    if (taken[to]) return false;
    taken[to] = true;
  }
  return true;
}

}  // namespace

bool match_component(const MeshDump& expected, const MeshDump& actual, Ref from, Ref to,
                     SurfaceMatch& match) {
  return ComponentMatcher(expected, actual, match).run(from, to);
}

bool match_surfaces(const MeshDump& expected, const MeshDump& actual,
                    const std::vector<Ref>& starts,
                    const std::function<std::vector<Ref>(Ref)>& candidates,
                    SurfaceMatch& match) {
  if (!(count(expected) == count(actual))) return false;
  for (Ref h : starts) {
    if (expected.halfedges[h].live == 0 || match.halfedge[h] != kUnsetRef) continue;
    bool matched = false;
    for (Ref candidate : candidates(h)) {
      matched = match_component(expected, actual, h, candidate, match);
      if (matched) break;
    }
    if (!matched) return false;
  }
  return is_injective(match.halfedge, actual.halfedges.size()) &&
         is_injective(match.vertex, actual.vertices.size()) &&
         is_injective(match.edge, actual.edges.size());
}

}  // namespace meshgrade
