#include "grader/judge/correspondence.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace meshgrade {
namespace {

/// More assignments than this are not tried: the best so far is taken. A mesh that is nearly
/// right needs a few hundred.
constexpr std::size_t kMostTrials = 20'000;

/// The elements of one kind that may stand for each other.
struct FreeElements {
  std::vector<Ref> expected;
  std::vector<Ref> actual;  ///< padded with kUnsetRef to the length of `expected`
};

template <class Records>
FreeElements free_elements(const Records& before, const Records& after, const Records& expected,
                           std::vector<Ref> old) {
  FreeElements free{old, std::move(old)};
  for (Ref i = static_cast<Ref>(before.size()); i < expected.size(); ++i) {
    free.expected.push_back(i);
  }
  for (Ref i = static_cast<Ref>(before.size()); i < after.size(); ++i) {
    if (after[i].live != 0) free.actual.push_back(i);
  }
  while (free.actual.size() < free.expected.size())
    free.actual.push_back(kUnsetRef);
  return free;
}

std::vector<Ref> identity(std::size_t size) {
  std::vector<Ref> map(size);
  std::iota(map.begin(), map.end(), Ref{0});
  return map;
}

class Search {
 public:
  Search(const MeshDump& before, const MeshDump& after, const MeshDump& expected, Ref edge,
         bool is_split)
      : after_(after), expected_(expected) {
    const Ref h = before.edges[edge].halfedge;
    const Ref t = before.halfedges[h].twin;
    std::vector<Ref> faces;
    for (Ref side : {h, t}) {
      const Ref f = before.halfedges[side].face;
      if ((f & kBoundaryBit) == 0) faces.push_back(f);
    }
    halfedges_ = free_elements(before.halfedges, after.halfedges, expected.halfedges, {h, t});
    vertices_ = free_elements(before.vertices, after.vertices, expected.vertices, {});
    edges_ = free_elements(before.edges, after.edges, expected.edges,
                           is_split ? std::vector<Ref>{edge} : std::vector<Ref>{});
    faces_ = free_elements(before.faces, after.faces, expected.faces, faces);
    order_by_neighbourhood();
    current_.halfedges = identity(expected.halfedges.size());
    current_.vertices = identity(expected.vertices.size());
    current_.edges = identity(expected.edges.size());
    current_.faces = identity(expected.faces.size());
    for (std::size_t i = 0; i < vertices_.expected.size(); ++i) {
      current_.vertices[vertices_.expected[i]] = vertices_.actual[i];
    }
    assigned_.assign(expected.halfedges.size(), true);
    for (Ref h2 : halfedges_.expected)
      assigned_[h2] = false;
    taken_.assign(halfedges_.actual.size(), false);
  }

  Correspondence run() {
    assign(0, 0);
    return best_;
  }

 private:
  /// Neighbours next to each other, so that a wrong choice is noticed at once.
  void order_by_neighbourhood() {
    std::vector<Ref> ordered;
    std::vector<Ref> waiting = halfedges_.expected;
    while (!waiting.empty()) {
      const auto touches = [&](Ref h) {
        return std::any_of(ordered.begin(), ordered.end(), [&](Ref g) {
          return expected_.halfedges[g].next == h || expected_.halfedges[g].twin == h ||
                 expected_.halfedges[h].next == g;
        });
      };
      auto found = std::find_if(waiting.begin(), waiting.end(), touches);
      if (found == waiting.end()) found = waiting.begin();
      ordered.push_back(*found);
      waiting.erase(found);
    }
    halfedges_.expected = ordered;
  }

  void assign(std::size_t depth, std::size_t cost) {
    if (cost >= best_cost_ || trials_ > kMostTrials) return;
    if (depth == halfedges_.expected.size()) return finish(cost);
    const Ref h = halfedges_.expected[depth];
    assigned_[h] = true;
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      if (taken_[i]) continue;
      ++trials_;
      taken_[i] = true;
      current_.halfedges[h] = halfedges_.actual[i];
      assign(depth + 1, cost + cost_of_halfedge(h));
      taken_[i] = false;
    }
    assigned_[h] = false;
  }

  /// Wrong cells among next, twin and vertex that became certain by assigning `h`.
  std::size_t cost_of_halfedge(Ref h) const {
    std::size_t cost = 0;
    const HalfedgeRecord& want = expected_.halfedges[h];
    const Ref mine = current_.halfedges[h];
    const HalfedgeRecord* have =
        mine < after_.halfedges.size() ? &after_.halfedges[mine] : nullptr;
    cost += wrong(have, &HalfedgeRecord::vertex, current_.vertices[want.vertex]);
    if (assigned_[want.next]) {
      cost += wrong(have, &HalfedgeRecord::next, current_.halfedges[want.next]);
    }
    if (assigned_[want.twin]) {
      cost += wrong(have, &HalfedgeRecord::twin, current_.halfedges[want.twin]);
    }
    return cost + cost_of_pointers_to(h);
  }

  std::size_t cost_of_pointers_to(Ref h) const {
    std::size_t cost = 0;
    const Ref twin = expected_.halfedges[h].twin;
    const Ref before = previous(h);
    const Ref mine = current_.halfedges[h];
    if (assigned_[twin]) cost += wrong(record(twin), &HalfedgeRecord::twin, mine);
    if (assigned_[before]) cost += wrong(record(before), &HalfedgeRecord::next, mine);
    return cost;
  }

  Ref previous(Ref h) const {
    Ref g = h;
    while (expected_.halfedges[g].next != h)
      g = expected_.halfedges[g].next;
    return g;
  }

  const HalfedgeRecord* record(Ref expected) const {
    const Ref mine = current_.halfedges[expected];
    return mine < after_.halfedges.size() ? &after_.halfedges[mine] : nullptr;
  }

  static std::size_t wrong(const HalfedgeRecord* have, Ref HalfedgeRecord::*pointer, Ref want) {
    return have == nullptr || want == kUnsetRef || have->*pointer != want ? 1 : 0;
  }

  /// With the half-edges fixed, edges and faces are independent of each other.
  void finish(std::size_t cost) {
    cost += best_permutation(edges_, current_.edges, [&](Ref e, Ref mine) {
      return cost_of_element(&HalfedgeRecord::edge, sides_of_edge(e), mine, after_.edges);
    });
    if (cost >= best_cost_) return;
    cost += best_permutation(faces_, current_.faces, [&](Ref f, Ref mine) {
      return cost_of_element(&HalfedgeRecord::face, sides_of_face(f), mine, after_.faces);
    });
    if (cost >= best_cost_) return;
    best_cost_ = cost;
    best_ = current_;
  }

  /// The expected half-edges of an edge or of a face.
  std::vector<Ref> sides_of_edge(Ref e) const {
    const Ref h = expected_.edges[e].halfedge;
    return {h, expected_.halfedges[h].twin};
  }
  std::vector<Ref> sides_of_face(Ref f) const {
    const Ref h = expected_.faces[f].halfedge;
    const Ref next = expected_.halfedges[h].next;
    return {h, next, expected_.halfedges[next].next};
  }

  /// Wrong cells if `mine` stands for an expected element with these half-edges: those that do
  /// not name it, and its own anchor.
  template <class Records>
  std::size_t cost_of_element(Ref HalfedgeRecord::*pointer, const std::vector<Ref>& sides,
                              Ref mine, const Records& records) const {
    std::size_t cost = 1;
    for (Ref h : sides) {
      cost += wrong(record(h), pointer, mine);
      const Ref half = current_.halfedges[h];
      if (mine < records.size() && half != kUnsetRef && records[mine].halfedge == half) --cost;
    }
    return cost;
  }

  template <class Cost>
  static std::size_t best_permutation(const FreeElements& free, std::vector<Ref>& map,
                                      Cost cost) {
    const std::size_t n = free.expected.size();
    if (n == 0) return 0;
    // Four at the most are expected; a student who makes many more is matched by the first.
    const std::size_t m = std::min<std::size_t>(free.actual.size(), 6);
    std::vector<std::size_t> order(m);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::size_t best = SIZE_MAX;
    do {
      std::size_t sum = 0;
      for (std::size_t i = 0; i < n && sum < best; ++i) {
        sum += cost(free.expected[i], free.actual[order[i]]);
      }
      if (sum >= best) continue;
      best = sum;
      for (std::size_t i = 0; i < n; ++i)
        map[free.expected[i]] = free.actual[order[i]];
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
  }

  const MeshDump& after_;
  const MeshDump& expected_;
  FreeElements halfedges_;
  FreeElements vertices_;
  FreeElements edges_;
  FreeElements faces_;
  std::vector<bool> assigned_;  // expected half-edge -> has its counterpart
  std::vector<bool> taken_;     // place in halfedges_.actual
  Correspondence current_;
  Correspondence best_;
  std::size_t best_cost_ = SIZE_MAX;
  std::size_t trials_ = 0;
};

}  // namespace

Correspondence find_correspondence(const MeshDump& before, const MeshDump& after,
                                   const MeshDump& expected, Ref edge, bool is_split) {
  return Search(before, after, expected, edge, is_split).run();
}

}  // namespace meshgrade
