#include "grader/judge/correspondence.h"

#include <algorithm>
#include <numeric>

#include "grader/judge/operation_model.h"
#include "grader/judge/role_search.h"

namespace meshgrade {
namespace {

/// So many elements that code has made beyond need are looked at as candidates.
constexpr std::size_t kMostSurplus = 12;
/// Half-edges far from the edge that the code has changed, too, may take part in the search.
constexpr std::size_t kMostFarOnes = 8;

std::vector<Ref> identity(std::size_t size) {
  std::vector<Ref> map(size);
  std::iota(map.begin(), map.end(), Ref{0});
  return map;
}

void add_once(std::vector<Ref>& list, Ref ref) {
  if (std::find(list.begin(), list.end(), ref) == list.end()) list.push_back(ref);
}

bool same(const HalfedgeRecord& x, const HalfedgeRecord& y) {
  return x.next == y.next && x.twin == y.twin && x.vertex == y.vertex && x.edge == y.edge &&
         x.face == y.face && x.live == y.live;
}

/// The parts are `old` and all that is new in `expected`; whoever is alive may take them.
template <class Records>
FreeElements free_elements(const Records& before, const Records& after, const Records& expected,
                           const std::vector<Ref>& old) {
  FreeElements free{old, {}};
  for (Ref i = static_cast<Ref>(before.size()); i < expected.size(); ++i)
    free.expected.push_back(i);
  for (Ref i : old) {
    if (i < after.size() && after[i].live != 0) free.actual.push_back(i);
  }
  const std::size_t most = free.expected.size() + kMostSurplus;
  for (Ref i = static_cast<Ref>(before.size()); i < after.size(); ++i) {
    if (after[i].live != 0 && free.actual.size() < most) free.actual.push_back(i);
  }
  return free;
}

/// The half-edges on both sides of the edge, of the faces there, and across from those: a right
/// answer may turn them along. Then those that the code has changed elsewhere.
std::vector<Ref> old_halfedges(const MeshDump& before, const MeshDump& after, Ref edge) {
  std::vector<Ref> list;
  const Ref first = before.edges[edge].halfedge;
  for (Ref side : {first, before.halfedges[first].twin}) {
    add_once(list, side);
    if ((before.halfedges[side].face & kBoundaryBit) != 0) continue;
    for (Ref h = before.halfedges[side].next; h != side; h = before.halfedges[h].next)
      add_once(list, h);
  }
  const std::size_t inner = list.size();
  for (std::size_t i = 0; i < inner; ++i)
    add_once(list, before.halfedges[list[i]].twin);
  const std::size_t most = list.size() + kMostFarOnes;
  const std::size_t known = std::min(before.halfedges.size(), after.halfedges.size());
  for (Ref h = 0; h < known && list.size() < most; ++h) {
    if (before.halfedges[h].live != 0 && !same(before.halfedges[h], after.halfedges[h]))
      add_once(list, h);
  }
  return list;
}

std::vector<Ref> inner_faces(const MeshDump& before, Ref edge) {
  std::vector<Ref> list;
  const Ref first = before.edges[edge].halfedge;
  for (Ref side : {first, before.halfedges[first].twin}) {
    const Ref face = before.halfedges[side].face;
    if ((face & kBoundaryBit) == 0) add_once(list, face);
  }
  return list;
}

/// The half-edges of the split vertex that lie along the edge that was split.
std::vector<Ref> along_edge(const MeshDump& before, const MeshDump& expected, Ref edge,
                            Ref split_vertex) {
  const Diamond diamond = diamond_of(before, edge);
  std::vector<Ref> list;
  for (Ref h = 0; h < expected.halfedges.size(); ++h) {
    const HalfedgeRecord& record = expected.halfedges[h];
    if (record.live == 0 || record.vertex != split_vertex) continue;
    const Ref end = expected.halfedges[record.twin].vertex;
    if (end == diamond.b || end == diamond.c) list.push_back(h);
  }
  return list;
}

/// An old element that was deleted still stands for itself, where nobody took its place: it is
/// told by its name then.
template <class Records>
void keep_deleted(const Records& after, const std::vector<Ref>& parts, std::vector<Ref>& map) {
  for (Ref part : parts) {
    if (part < after.size() && after[part].live == 0 && map[part] == kUnsetRef)
      map[part] = part;
  }
}

}  // namespace

Correspondence find_correspondence(const MeshDump& before, const MeshDump& after,
                                   const MeshDump& expected, Ref edge, Ref split_vertex) {
  const bool is_split = split_vertex != kUnsetRef;
  RoleProblem problem{
      after,
      expected,
      free_elements(before.halfedges, after.halfedges, expected.halfedges,
                    old_halfedges(before, after, edge)),
      free_elements(before.edges, after.edges, expected.edges,
                    is_split ? std::vector<Ref>{edge} : std::vector<Ref>{}),
      free_elements(before.faces, after.faces, expected.faces, inner_faces(before, edge)),
      split_vertex,
      is_split ? along_edge(before, expected, edge, split_vertex) : std::vector<Ref>{}};
  FreeElements vertices = free_elements(before.vertices, after.vertices, expected.vertices, {});
  if (vertices.actual.empty()) vertices.actual.push_back(kUnsetRef);
  Correspondence best;
  std::size_t least = SIZE_MAX;
  for (Ref vertex : vertices.actual) {
    Correspondence tried{identity(expected.halfedges.size()),
                         identity(expected.vertices.size()), identity(expected.edges.size()),
                         identity(expected.faces.size())};
    if (is_split) tried.vertices[split_vertex] = vertex;
    const std::size_t wrong = assign_roles(problem, least, tried);
    if (wrong < least) {
      least = wrong;
      best = std::move(tried);
    }
    if (!is_split) break;
  }
  keep_deleted(after.halfedges, problem.halfedges.expected, best.halfedges);
  keep_deleted(after.edges, problem.edges.expected, best.edges);
  keep_deleted(after.faces, problem.faces.expected, best.faces);
  return best;
}

}  // namespace meshgrade
