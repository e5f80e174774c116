#include "grader/judge/role_search.h"

#include <algorithm>
#include <map>
#include <utility>

#include "grader/judge/label_choice.h"

namespace meshgrade {
namespace {

/// A mesh that is nearly right takes a few dozen; after so many the best so far is taken.
constexpr std::size_t kMostSteps = 1'500;

constexpr std::size_t kNobody = SIZE_MAX;

using Pointer = Ref HalfedgeRecord::*;

/// What is known of a part before any is given away.
struct Role {
  Ref expected = kUnsetRef;
  // Places in the list of parts; kNobody where it is no free part.
  std::size_t next = kNobody;
  std::size_t previous = kNobody;
  std::size_t twin = kNobody;
  std::size_t edge = kNobody;  ///< place in the list of free edges
  std::size_t face = kNobody;
};

class Search {
 public:
  Search(const RoleProblem& problem, std::size_t bound, Correspondence& start)
      : problem_(problem),
        after_(problem.after),
        expected_(problem.expected),
        current_(start),
        best_(start),
        best_cost_(bound) {
    candidates_ = problem.halfedges.actual;
    // As many as there are parts may be missing.
    candidates_.resize(std::max(candidates_.size(), problem.halfedges.expected.size()),
                       kUnsetRef);
    order_roles();
    link_roles();
    fill_costs();
    player_.assign(roles_.size(), kNobody);
    taken_.assign(candidates_.size(), false);
  }

  /// Tries with few wrong pointers first: then a wrong choice ends soon.
  std::size_t run(Correspondence& result) {
    const std::size_t bound = best_cost_;
    for (std::size_t limit = 1; limit < bound; limit += 1 + limit / 2) {
      best_cost_ = limit;
      steps_ = 0;
      descend(0, 0);
      if (best_cost_ < limit || steps_ > kMostSteps) break;
    }
    if (best_player_.empty()) {
      best_cost_ = bound;
      steps_ = 0;
      descend(0, 0);
    }
    if (steps_ > kMostSteps) improve_by_exchange();
    result = best_;
    return best_cost_;
  }

 private:
  // ---- what is known before the search --------------------------------------------------

  /// Neighbours next to each other, so that a wrong choice is noticed at once, and first those
  /// whose edge is known.
  void order_roles() {
    std::vector<Ref> waiting = problem_.halfedges.expected;
    const auto& free = problem_.edges.expected;
    std::stable_partition(waiting.begin(), waiting.end(), [&](Ref h) {
      return std::find(free.begin(), free.end(), expected_.halfedges[h].edge) == free.end();
    });
    while (!waiting.empty()) {
      auto found = std::find_if(waiting.begin(), waiting.end(), [&](Ref h) {
        return std::any_of(roles_.begin(), roles_.end(), [&](const Role& role) {
          const HalfedgeRecord& record = expected_.halfedges[role.expected];
          return record.next == h || record.twin == h ||
                 expected_.halfedges[h].next == role.expected;
        });
      });
      if (found == waiting.end()) found = waiting.begin();
      roles_.push_back({*found});
      waiting.erase(found);
    }
  }

  void link_roles() {
    const auto place_in = [](const std::vector<Ref>& list, Ref ref) {
      const auto found = std::find(list.begin(), list.end(), ref);
      return found == list.end() ? kNobody : static_cast<std::size_t>(found - list.begin());
    };
    for (std::size_t i = 0; i < roles_.size(); ++i)
      role_place_[roles_[i].expected] = i;
    edge_groups_.resize(problem_.edges.expected.size());
    face_groups_.resize(problem_.faces.expected.size());
    for (std::size_t i = 0; i < roles_.size(); ++i) {
      Role& role = roles_[i];
      const HalfedgeRecord& record = expected_.halfedges[role.expected];
      role.next = role_of(record.next);
      role.twin = role_of(record.twin);
      role.edge = place_in(problem_.edges.expected, record.edge);
      role.face = place_in(problem_.faces.expected, record.face);
      if (role.next != kNobody) roles_[role.next].previous = i;
      if (role.edge != kNobody) edge_groups_[role.edge].push_back(i);
      if (role.face != kNobody) face_groups_[role.face].push_back(i);
    }
    for (Ref g = 0; g < expected_.halfedges.size(); ++g) {
      if (expected_.halfedges[g].live == 0 || role_of(g) != kNobody) continue;
      const std::size_t after = role_of(expected_.halfedges[g].next);
      if (after != kNobody) fixed_before_.emplace(after, g);
      const std::size_t twin = role_of(expected_.halfedges[g].twin);
      if (twin != kNobody) fixed_twin_.emplace(twin, g);
    }
  }

  std::size_t role_of(Ref expected) const {
    const auto found = role_place_.find(expected);
    return found == role_place_.end() ? kNobody : found->second;
  }

  /// Wrong pointers of each part under each candidate that do not depend on other parts.
  void fill_costs() {
    cost_.assign(roles_.size(), std::vector<std::size_t>(candidates_.size(), 0));
    least_rest_.assign(roles_.size() + 1, 0);
    for (std::size_t i = roles_.size(); i-- > 0;) {
      for (std::size_t j = 0; j < candidates_.size(); ++j)
        cost_[i][j] = cost_alone(i, candidates_[j]);
      least_rest_[i] = least_rest_[i + 1] + *std::min_element(cost_[i].begin(), cost_[i].end());
    }
  }

  const HalfedgeRecord* record_of(Ref mine) const {
    return mine < after_.halfedges.size() ? &after_.halfedges[mine] : nullptr;
  }

  static std::size_t wrong(const HalfedgeRecord* have, Pointer pointer, Ref want) {
    return have == nullptr || want == kUnsetRef || have->*pointer != want ? 1 : 0;
  }

  std::size_t cost_alone(std::size_t i, Ref mine) const {
    const Role& role = roles_[i];
    const HalfedgeRecord& want = expected_.halfedges[role.expected];
    const HalfedgeRecord* have = record_of(mine);
    std::size_t cost = wrong(have, &HalfedgeRecord::vertex, current_.vertices[want.vertex]);
    if (role.edge == kNobody) cost += wrong(have, &HalfedgeRecord::edge, want.edge);
    if (role.face == kNobody) cost += wrong(have, &HalfedgeRecord::face, want.face);
    if (role.next == kNobody) cost += wrong(have, &HalfedgeRecord::next, want.next);
    if (role.twin == kNobody) cost += wrong(have, &HalfedgeRecord::twin, want.twin);
    const auto before = fixed_before_.find(i);
    if (before != fixed_before_.end())
      cost += wrong(record_of(before->second), &HalfedgeRecord::next, mine);
    const auto twin = fixed_twin_.find(i);
    if (twin != fixed_twin_.end())
      cost += wrong(record_of(twin->second), &HalfedgeRecord::twin, mine);
    return cost;
  }

  // ---- the search ------------------------------------------------------------------------

  Ref mine(std::size_t role) const { return candidates_[player_[role]]; }

  void descend(std::size_t i, std::size_t cost) {
    if (i == roles_.size()) return finish(cost);
    std::vector<std::pair<std::size_t, std::size_t>> choices;  // cost, candidate
    bool has_missing = false;
    for (std::size_t j = 0; j < candidates_.size(); ++j) {
      if (taken_[j]) continue;
      // One that is missing is like another.
      if (candidates_[j] == kUnsetRef && std::exchange(has_missing, true)) continue;
      player_[i] = j;
      choices.emplace_back(cost_[i][j] + cost_of_links(i), j);
    }
    std::stable_sort(choices.begin(), choices.end(), [&](const auto& x, const auto& y) {
      if (x.first != y.first) return x.first < y.first;
      return candidates_[x.second] == roles_[i].expected &&
             candidates_[y.second] != roles_[i].expected;
    });
    for (const auto& [more, j] : choices) {
      if (cost + more + least_rest_[i + 1] >= best_cost_ || ++steps_ > kMostSteps) break;
      player_[i] = j;
      taken_[j] = true;
      descend(i + 1, cost + more);
      taken_[j] = false;
    }
    player_[i] = kNobody;
  }

  bool is_given(std::size_t role) const { return role != kNobody && player_[role] != kNobody; }

  /// Pointers between part `i` and the parts before it that are wrong for certain, and what its
  /// edge and its face cost more at least.
  std::size_t cost_of_links(std::size_t i) const {
    const Role& role = roles_[i];
    const HalfedgeRecord* have = record_of(mine(i));
    std::size_t cost = 0;
    if (is_given(role.next)) cost += wrong(have, &HalfedgeRecord::next, mine(role.next));
    if (is_given(role.previous))
      cost += wrong(record_of(mine(role.previous)), &HalfedgeRecord::next, mine(i));
    if (is_given(role.twin)) {
      cost += wrong(have, &HalfedgeRecord::twin, mine(role.twin)) +
              wrong(record_of(mine(role.twin)), &HalfedgeRecord::twin, mine(i));
    }
    return cost + cost_of_joining(i, role.edge, edge_groups_, &HalfedgeRecord::edge) +
           cost_of_joining(i, role.face, face_groups_, &HalfedgeRecord::face);
  }

  /// How many more of the half-edges of one edge or face name another one than most of them do,
  /// with part `i` than without.
  std::size_t cost_of_joining(std::size_t i, std::size_t group,
                              const std::vector<std::vector<std::size_t>>& groups,
                              Pointer label) const {
    if (group == kNobody) return 0;
    std::vector<Ref> names;
    for (std::size_t role : groups[group]) {
      const HalfedgeRecord* have =
          role != i && is_given(role) ? record_of(mine(role)) : nullptr;
      if (have != nullptr) names.push_back(have->*label);
    }
    const HalfedgeRecord* have = record_of(mine(i));
    if (have == nullptr) return 1;
    const std::size_t without = most_frequent(names);
    names.push_back(have->*label);
    return 1 - (most_frequent(names) - without);
  }

  static std::size_t most_frequent(const std::vector<Ref>& names) {
    std::ptrdiff_t most = 0;
    for (Ref name : names)
      most = std::max(most, std::count(names.begin(), names.end(), name));
    return static_cast<std::size_t>(most);
  }

  void finish(std::size_t cost_so_far) {
    if (cost_so_far >= best_cost_) return;
    place_players();
    const std::size_t cost = whole_cost();
    if (cost >= best_cost_) return;
    best_cost_ = cost;
    best_ = current_;
    best_player_ = player_;
  }

  // ---- one whole assignment ---------------------------------------------------------------

  void place_players() {
    for (std::size_t i = 0; i < roles_.size(); ++i)
      current_.halfedges[roles_[i].expected] = mine(i);
  }

  /// All wrong pointers that depend on the choice; gives away edges and faces on the way.
  std::size_t whole_cost() {
    std::size_t cost = 0;
    for (std::size_t i = 0; i < roles_.size(); ++i) {
      const HalfedgeRecord* have = record_of(mine(i));
      cost += cost_[i][player_[i]];
      const Role& role = roles_[i];
      if (role.next != kNobody) cost += wrong(have, &HalfedgeRecord::next, mine(role.next));
      if (role.twin != kNobody) cost += wrong(have, &HalfedgeRecord::twin, mine(role.twin));
    }
    return cost +
           give_labels(problem_.edges, current_.edges, &HalfedgeRecord::edge, expected_.edges,
                       after_.edges) +
           give_labels(problem_.faces, current_.faces, &HalfedgeRecord::face, expected_.faces,
                       after_.faces) +
           wrong_anchors();
  }

  template <class Records>
  std::size_t give_labels(const FreeElements& free, std::vector<Ref>& map, Pointer label,
                          const Records& expected, const Records& actual) const {
    std::vector<WantedLabel> wanted;
    for (Ref element : free.expected) {
      WantedLabel w{element, {}, {}};
      std::vector<Ref> players;
      for (Ref h : halfedges_of(label, expected[element].halfedge)) {
        players.push_back(current_.halfedges[h]);
        const HalfedgeRecord* have = record_of(players.back());
        w.named.push_back(have == nullptr ? kUnsetRef : have->*label);
      }
      for (Ref ref : free.actual) {
        const Ref anchor = actual[ref].halfedge;
        if (std::find(players.begin(), players.end(), anchor) != players.end() &&
            anchor != kUnsetRef) {
          w.anchoring.push_back(ref);
        }
      }
      wanted.push_back(std::move(w));
    }
    std::vector<Ref> chosen;
    const std::size_t cost = choose_labels(wanted, free.actual, chosen);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      map[wanted[i].element] = chosen[i];
    return cost;
  }

  std::vector<Ref> halfedges_of(Pointer label, Ref first) const {
    if (label == &HalfedgeRecord::edge) return {first, expected_.halfedges[first].twin};
    std::vector<Ref> loop;
    Ref h = first;
    do {
      loop.push_back(h);
      h = expected_.halfedges[h].next;
    } while (h != first);
    return loop;
  }

  /// Anchors of vertices, and of edges and faces that are not free, which must be one of the
  /// free parts.
  std::size_t wrong_anchors() const {
    std::map<Ref, Ref> stands_for;
    for (const Role& role : roles_) {
      const Ref own = current_.halfedges[role.expected];
      if (own != kUnsetRef) stands_for[own] = role.expected;
    }
    const auto part_of = [&](Ref own) {
      const auto found = stands_for.find(own);
      if (found != stands_for.end()) return found->second;
      const bool is_fixed = own < expected_.halfedges.size() && role_of(own) == kNobody;
      return is_fixed ? own : kUnsetRef;
    };
    std::size_t cost = 0;
    const auto check = [&](const auto& records, Ref own, Ref element, Pointer pointer) {
      const Ref part = own < records.size() ? part_of(records[own].halfedge) : kUnsetRef;
      const bool right = part != kUnsetRef && expected_.halfedges[part].*pointer == element;
      const bool fits = element != problem_.split_vertex ||
                        pointer != &HalfedgeRecord::vertex || is_along(part);
      if (!right || !fits) ++cost;
    };
    for (Ref v : touched(&HalfedgeRecord::vertex))
      check(after_.vertices, current_.vertices[v], v, &HalfedgeRecord::vertex);
    for (Ref e : touched(&HalfedgeRecord::edge)) {
      if (is_fixed_in(problem_.edges, e)) check(after_.edges, e, e, &HalfedgeRecord::edge);
    }
    for (Ref f : touched(&HalfedgeRecord::face)) {
      if ((f & kBoundaryBit) == 0 && is_fixed_in(problem_.faces, f))
        check(after_.faces, f, f, &HalfedgeRecord::face);
    }
    return cost;
  }

  bool is_along(Ref part) const {
    return std::find(problem_.along.begin(), problem_.along.end(), part) !=
           problem_.along.end();
  }

  static bool is_fixed_in(const FreeElements& free, Ref ref) {
    return std::find(free.expected.begin(), free.expected.end(), ref) == free.expected.end();
  }

  /// What the free parts belong to.
  std::vector<Ref> touched(Pointer pointer) const {
    std::vector<Ref> list;
    for (const Role& role : roles_)
      list.push_back(expected_.halfedges[role.expected].*pointer);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  /// The best of a search that was ended, made better as long as two parts can be exchanged
  /// with gain.
  void improve_by_exchange() {
    if (best_player_.empty()) return;
    bool better = true;
    while (better) {
      better = false;
      player_ = best_player_;
      for (std::size_t i = 0; i < roles_.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const std::size_t known = best_cost_;
          std::swap(player_[i], player_[j]);
          finish(0);
          if (best_cost_ < known)
            better = true;
          else
            std::swap(player_[i], player_[j]);
        }
      }
    }
  }

  const RoleProblem& problem_;
  const MeshDump& after_;
  const MeshDump& expected_;
  std::vector<Role> roles_;
  std::vector<Ref> candidates_;
  std::map<Ref, std::size_t> role_place_;              // expected half-edge -> place in roles_
  std::vector<std::vector<std::size_t>> edge_groups_;  // free edge -> its parts
  std::vector<std::vector<std::size_t>> face_groups_;
  std::map<std::size_t, Ref> fixed_before_;  // part -> who leads to it and is not free
  std::map<std::size_t, Ref> fixed_twin_;
  std::vector<std::vector<std::size_t>> cost_;  // [part][candidate]
  std::vector<std::size_t> least_rest_;         // of all parts from this one on
  std::vector<std::size_t> player_;             // part -> candidate
  std::vector<bool> taken_;                     // by candidate
  std::vector<std::size_t> best_player_;
  Correspondence current_;
  Correspondence best_;
  std::size_t best_cost_;
  std::size_t steps_ = 0;
};

}  // namespace

std::size_t assign_roles(const RoleProblem& problem, std::size_t bound, Correspondence& start) {
  return Search(problem, bound, start).run(start);
}

}  // namespace meshgrade
