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

bool same(const HalfedgeRecord& a, const HalfedgeRecord& b) {
  return a.next == b.next && a.twin == b.twin && a.vertex == b.vertex && a.edge == b.edge &&
         a.face == b.face && a.live == b.live;
}
template <class Record>
bool same(const Record& a, const Record& b) {
  return a.halfedge == b.halfedge && a.live == b.live;
}

template <class Record, class Name>
void compare(const std::vector<Record>& before, const std::vector<Record>& after, Name name,
             std::size_t most, std::vector<PointerChange>& changes) {
  for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i) {
    if (changes.size() >= most) return;
    // Names cost time, and most records of a large mesh are as they were.
    if (i < before.size() && i < after.size() && same(before[i], after[i])) continue;
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

std::vector<PointerChange> find_changes(const MeshDump& before, const MeshDump& after,
                                        std::size_t most) {
  std::vector<PointerChange> changes;
  compare(before.halfedges, after.halfedges, halfedge_name, most, changes);
  compare(before.vertices, after.vertices, vertex_name, most, changes);
  compare(before.edges, after.edges, edge_name, most, changes);
  compare(before.faces, after.faces, face_name, most, changes);
  compare(
      before.boundaries, after.boundaries, [](Ref b) { return face_name(b | kBoundaryBit); },
      most, changes);
  // An element may have more pointers than there was room for.
  if (changes.size() > most) changes.resize(most);
  return changes;
}

}  // namespace meshgrade
