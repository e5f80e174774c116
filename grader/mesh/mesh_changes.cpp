#include "grader/mesh/mesh_changes.h"

#include <algorithm>
#include <utility>

namespace meshgrade {
namespace {

using Pointers = std::vector<std::pair<const char*, std::string>>;

Pointers pointers_of(const HalfedgeRecord& h) {
  return {{"next", halfedge_name(h.next)},
          {"twin", halfedge_name(h.twin)},
          {"vertex", vertex_name(h.vertex)},
          {"edge", edge_name(h.edge)},
          {"face", face_name(h.face)}};
}

/// Vertices, edges and faces.
template <class Record>
Pointers pointers_of(const Record& record) {
  return {{"halfedge", halfedge_name(record.halfedge)}};
}

template <class Record>
Pointers live_pointers(const std::vector<Record>& records, std::size_t i) {
  if (i >= records.size() || records[i].live == 0) return {};
  return pointers_of(records[i]);
}

template <class Record, class Name>
void compare(const std::vector<Record>& before, const std::vector<Record>& after, Name name,
             std::vector<PointerChange>& changes) {
  for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i) {
    const Pointers was = live_pointers(before, i);
    const Pointers is = live_pointers(after, i);
    for (std::size_t p = 0; p < std::max(was.size(), is.size()); ++p) {
      const std::string old_target = was.empty() ? "" : was[p].second;
      const std::string new_target = is.empty() ? "" : is[p].second;
      if (old_target == new_target) continue;
      changes.push_back({name(static_cast<Ref>(i)), (is.empty() ? was : is)[p].first,
                         old_target, new_target});
    }
  }
}

}  // namespace

std::vector<PointerChange> find_changes(const MeshDump& before, const MeshDump& after) {
  std::vector<PointerChange> changes;
  compare(before.halfedges, after.halfedges, halfedge_name, changes);
  compare(before.vertices, after.vertices, vertex_name, changes);
  compare(before.edges, after.edges, edge_name, changes);
  compare(before.faces, after.faces, face_name, changes);
  compare(
      before.boundaries, after.boundaries, [](Ref b) { return face_name(b | kBoundaryBit); },
      changes);
  return changes;
}

}  // namespace meshgrade
