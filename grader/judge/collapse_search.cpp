#include "grader/judge/collapse_search.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "grader/judge/point_compare.h"

namespace meshgrade {
namespace {

bool is_live(const MeshDump& mesh, Ref vertex) {
  return vertex < mesh.vertices.size() && mesh.vertices[vertex].live != 0;
}

std::vector<Corners> sorted_faces(std::vector<Corners> faces) {
  for (Corners& face : faces)
    face = canonical(std::move(face));
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// The records that can stand for vertices that were made of several: an old one of them, or a
/// new one. Empty if they do not come out even.
MergedRefs find_merged(const CollapsingMesh& mesh, const MeshDump& after) {
  std::set<Ref> fresh;
  for (auto v = static_cast<Ref>(mesh.lists().positions.size()); v < after.vertices.size();
       ++v) {
    if (is_live(after, v)) fresh.insert(v);
  }
  MergedRefs refs;
  for (const auto& [label, members] : mesh.merged_vertices()) {
    std::vector<Ref> live;
    for (const Label member : members) {
      if (is_live(after, member)) live.push_back(member);
    }
    if (live.empty() && !fresh.empty()) {
      const Point3& at = mesh.lists().positions[label];
      live.push_back(*std::min_element(fresh.begin(), fresh.end(), [&](Ref v, Ref w) {
        return distance(after.vertices[v].position, at) <
               distance(after.vertices[w].position, at);
      }));
      fresh.erase(live.back());
    }
    if (live.size() != 1) return {};
    refs[label] = live[0];
  }
  return fresh.empty() ? refs : MergedRefs{};
}

}  // namespace

std::optional<MergedRefs> match_collapsed(const CollapsingMesh& mesh, const MeshDump& after) {
  const MergedRefs refs = find_merged(mesh, after);
  if (refs.size() != mesh.merged_vertices().size()) return {};
  std::map<Ref, Label> label_of;
  for (const auto& [label, ref] : refs)
    label_of[ref] = label;
  std::vector<Corners> faces = face_lists_of(after).faces;
  for (Corners& face : faces) {
    for (Label& corner : face) {
      const auto merged_vertex = label_of.find(corner);
      if (merged_vertex != label_of.end()) {
        corner = merged_vertex->second;
      } else if (corner >= mesh.lists().positions.size() ||
                 after.vertices[corner].position != mesh.lists().positions[corner]) {
        return {};
      }
    }
  }
  if (sorted_faces(std::move(faces)) != sorted_faces(mesh.lists().faces)) return {};
  return refs;
}

namespace {

/// The costs of points in float, or in another order of the terms.
constexpr double kCostTolerance = 1e-3;
constexpr std::size_t kMostTried = 300;

struct Found {
  CollapsingMesh mesh;
  std::map<Label, DoneCollapse> last;  ///< of each vertex that was left by collapses
  std::map<Label, double> allowed;     ///< what it may cost where it lies
};

class FitSearch {
 public:
  explicit FitSearch(const MeshDump& after) : after_(after), is_open_(false) {}

  CollapseFit search(const Found& found, std::size_t n, bool is_open) {
    is_open_ = is_open;
    visit(found, n);
    return best_;
  }

 private:
  bool is_decided() const { return best_.fit == Fit::kFits || best_.fit == Fit::kUnknown; }

  void visit(const Found& found, std::size_t n) {
    if (++tried_ > kMostTried) best_.fit = Fit::kUnknown;
    if (is_decided()) return;
    if (n == 0) return compare(found);
    const double most = cheapest_required(found.mesh);
    for (const LabelPair& edge : found.mesh.edges()) {
      if (is_live(after_, edge.first) && is_live(after_, edge.second)) continue;
      const EdgeCost cost = found.mesh.cost(edge);
      const double rounding = found.mesh.rounding(edge);
      if (!(cost.least <= (1.0 + kCostTolerance) * most + rounding)) continue;
      if (n > 1 && (!cost.has_single_point || !found.mesh.is_sound(edge))) {
        best_.fit = Fit::kUnknown;
        return;
      }
      const bool is_free = is_open_ && (found.mesh.is_boundary(edge.first) ||
                                        found.mesh.is_boundary(edge.second));
      visit(after_collapse(found, {edge, cost}, is_free ? most : cost.most, rounding), n - 1);
      if (is_decided()) return;
    }
  }

  /// Infinite if none must be collapsed.
  double cheapest_required(const CollapsingMesh& mesh) const {
    double least = INFINITY;
    for (const LabelPair& edge : mesh.edges()) {
      if (is_open_ && (mesh.is_boundary(edge.first) || mesh.is_boundary(edge.second))) continue;
      const EdgeCost cost = mesh.cost(edge);
      if (cost.most >= least || !mesh.is_sound(edge) || mesh.turns_a_face(edge, cost.at))
        continue;
      least = cost.most;
    }
    return least;
  }

  static Found after_collapse(const Found& found, const DoneCollapse& done, double most,
                              double rounding) {
    Found next{found.mesh.collapsed(done.edge, done.cost.at), found.last, found.allowed};
    next.last.erase(done.edge.second);
    next.allowed.erase(done.edge.second);
    next.last[done.edge.first] = done;
    next.allowed[done.edge.first] = (1.0 + kCostTolerance) * most + rounding;
    return next;
  }

  void compare(const Found& found) {
    const auto refs = match_collapsed(found.mesh, after_);
    if (!refs) return;
    best_.fit = Fit::kFits;
    for (const auto& [label, ref] : *refs) {
      const double actual = found.mesh.quadric_at(label, after_.vertices[ref].position);
      if (actual <= found.allowed.at(label)) continue;
      const EdgeCost& cost = found.last.at(label).cost;
      best_ = {Fit::kOtherPoints, ref, cost.at, cost.most, actual};
      return;
    }
  }

  const MeshDump& after_;
  bool is_open_;
  std::size_t tried_ = 0;
  CollapseFit best_;
};

bool has_boundary_edge(const CollapsingMesh& mesh) {
  const std::vector<LabelPair> edges = mesh.edges();
  return std::any_of(edges.begin(), edges.end(),
                     [&](const LabelPair& edge) { return mesh.is_boundary(edge.first); });
}

}  // namespace

CollapseFit fit_collapses(const FaceLists& before, const CollapseWay& way, std::size_t n,
                          const MeshDump& after) {
  const CollapsingMesh start(before, way);
  return FitSearch(after).search({start, {}, {}}, n, has_boundary_edge(start));
}

namespace {

struct Ranked {
  double rank = 0.0;
  Point3 at{};
};

using Ranks = std::map<LabelPair, Ranked>;

Ranked ranked(const CollapsingMesh& mesh, const LabelPair& edge) {
  Ranked of;
  of.rank = mesh.rank(edge, of.at);
  return of;
}

/// The ranks after a collapse, whose vertex has the label of the smaller end.
Ranks renewed(const Ranks& old, const LabelPair& collapsed, const CollapsingMesh& mesh,
              Renewal renewal) {
  const auto [left, gone] = collapsed;
  Ranks ranks;
  for (const auto& [edge, before] : old) {
    Ranked value = before;
    const bool is_touched =
        edge.first == left || edge.second == left || edge.first == gone || edge.second == gone;
    if (edge == collapsed) continue;
    const Label a = edge.first == gone ? left : edge.first;
    const Label b = edge.second == gone ? left : edge.second;
    const LabelPair now(std::min(a, b), std::max(a, b));
    if (is_touched && renewal != Renewal::kOldBest) value = ranked(mesh, now);
    if (renewal == Renewal::kOldCosts) value.rank = before.rank;
    const auto [known, is_new] = ranks.emplace(now, value);
    if (!is_new && value.rank < known->second.rank) known->second = value;
  }
  return ranks;
}

}  // namespace

CollapsePath cheapest_collapses(const FaceLists& before, const CollapseWay& way,
                                std::size_t n) {
  CollapsePath path{{}, CollapsingMesh(before, way)};
  Ranks ranks;
  for (const LabelPair& edge : path.left.edges())
    ranks[edge] = ranked(path.left, edge);
  while (path.done.size() < n && !ranks.empty()) {
    const auto first = std::min_element(
        ranks.begin(), ranks.end(),
        [](const auto& p, const auto& q) { return p.second.rank < q.second.rank; });
    const LabelPair edge = first->first;
    const Point3 at = first->second.at;
    if (!path.left.is_sound(edge)) {
      ranks.erase(first);
      continue;
    }
    path.done.push_back({edge, path.left.cost(edge)});
    path.left = path.left.collapsed(edge, at);
    ranks = renewed(ranks, edge, path.left, way.renewal);
  }
  return path;
}

bool is_left_by(const CollapsePath& path, const MeshDump& after, double allowed) {
  const auto refs = match_collapsed(path.left, after);
  return refs && std::all_of(refs->begin(), refs->end(), [&](const auto& merged_vertex) {
           return distance(path.left.lists().positions[merged_vertex.first],
                           after.vertices[merged_vertex.second].position) <= allowed;
         });
}

}  // namespace meshgrade
