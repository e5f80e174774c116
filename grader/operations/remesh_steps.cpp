#include "grader/operations/remesh_steps.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "grader/operations/local_operation_list.h"

namespace meshgrade {
namespace {

/// Lengths within this part of a limit are neither more nor less: they may be computed in
/// float, and the mean may be taken before or after the splits.
constexpr double kMargin = 1e-3;

/// A limit that right solutions may take otherwise, but within these.
struct Limit {
  double least;
  double most;
  bool is_below(double length) const { return length > (1.0 + kMargin) * most; }
  bool is_above(double length) const { return length < (1.0 - kMargin) * least; }
  bool is_unclear(double length) const { return !is_below(length) && !is_above(length); }
};

Answer answer_of(const char* operation, const FaceLists& lists, const EdgeEnds& edge) {
  return find_local_operation(operation)->answer(lists, {{edge.first, edge.second}});
}

/// Whether two of these edges are sides of one face.
bool share_a_face(const FaceLists& lists, const std::set<EdgeEnds>& edges) {
  return std::any_of(lists.faces.begin(), lists.faces.end(), [&](const Corners& face) {
    std::size_t sides = 0;
    for (std::size_t i = 0; i < face.size(); ++i)
      sides += edges.count(std::minmax(face[i], face[(i + 1) % face.size()]));
    return sides > 1;
  });
}

std::optional<FaceLists> split_beyond(const FaceLists& lists, const Limit& limit) {
  std::set<EdgeEnds> too_long;
  for (const EdgeEnds& edge : edges_of(lists)) {
    const double length = edge_length(lists, edge);
    if (limit.is_unclear(length)) return std::nullopt;
    if (limit.is_below(length)) too_long.insert(edge);
  }
  if (share_a_face(lists, too_long)) return std::nullopt;
  FaceLists after = lists;
  for (const EdgeEnds& edge : too_long)
    after = answer_of("edge_split_polygon", after, edge).after;
  const std::vector<EdgeEnds> left = edges_of(after);
  const bool is_done = std::all_of(left.begin(), left.end(), [&](const EdgeEnds& edge) {
    return limit.is_above(edge_length(after, edge));
  });
  return is_done ? std::optional(after) : std::nullopt;
}

/// The ends of an edge and their neighbours.
std::set<Label> around(const Surface& surface, const EdgeEnds& edge) {
  const std::span<const Label> its = surface.neighbours(edge.first);
  const std::span<const Label> others = surface.neighbours(edge.second);
  std::set<Label> labels(its.begin(), its.end());
  labels.insert(others.begin(), others.end());
  return labels;
}

/// Whether no vertex around one of these edges is around another one.
bool lie_apart(const Surface& surface, const std::set<EdgeEnds>& edges) {
  std::set<Label> taken;
  for (const EdgeEnds& edge : edges) {
    for (const Label label : around(surface, edge)) {
      if (!taken.insert(label).second) return false;
    }
  }
  return true;
}

std::optional<FaceLists> collapsed_below(const FaceLists& lists, const Limit& limit) {
  std::set<EdgeEnds> too_short;
  for (const EdgeEnds& edge : edges_of(lists)) {
    const double length = edge_length(lists, edge);
    if (limit.is_unclear(length)) return std::nullopt;
    if (limit.is_above(length)) too_short.insert(edge);
  }
  std::set<EdgeEnds> refused;
  for (const EdgeEnds& edge : too_short) {
    if (answer_of("edge_collapse", lists, edge).demand == Demand::kRefuse) refused.insert(edge);
  }
  // Where all are refused, nothing changes that another one could depend on.
  if (refused == too_short) return lists;
  if (!lie_apart(Surface(lists), too_short)) return std::nullopt;
  FaceLists after = lists;
  for (const EdgeEnds& edge : too_short) {
    if (refused.count(edge) != 0) continue;
    Answer answer = answer_of("edge_collapse", after, edge);
    if (answer.demand != Demand::kMust) return std::nullopt;
    after = std::move(answer.after);
  }
  for (const EdgeEnds& edge : edges_of(after)) {
    const bool is_long_enough = limit.is_below(edge_length(after, edge));
    if (!is_long_enough && refused.count(edge) == 0) return std::nullopt;
  }
  return after;
}

std::vector<FlipPlace> all_flip_places(const Surface& surface, const FaceLists& lists) {
  std::vector<FlipPlace> places;
  for (const EdgeEnds& edge : edges_of(lists)) {
    if (const auto place = flip_place(surface, lists, edge)) places.push_back(*place);
  }
  return places;
}

/// Whether the four corners of each edge are those of at most one of these places, so that what
/// a flip is worth depends on one of the others at most.
bool are_independent(const std::vector<FlipPlace>& all, const std::vector<FlipPlace>& chosen) {
  std::map<Label, std::size_t> owner;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (const Label label : {chosen[i].a, chosen[i].b, chosen[i].c, chosen[i].d}) {
      if (!owner.insert({label, i}).second) return false;
    }
  }
  return std::all_of(all.begin(), all.end(), [&](const FlipPlace& place) {
    std::set<std::size_t> touched;
    for (const Label label : {place.a, place.b, place.c, place.d}) {
      const auto found = owner.find(label);
      if (found != owner.end()) touched.insert(found->second);
    }
    return touched.size() < 2;
  });
}

}  // namespace

std::vector<EdgeEnds> edges_of(const FaceLists& lists) {
  std::vector<EdgeEnds> edges;
  for (const Corners& face : lists.faces) {
    for (std::size_t i = 0; i < face.size(); ++i)
      edges.push_back(std::minmax(face[i], face[(i + 1) % face.size()]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double edge_length(const FaceLists& lists, const EdgeEnds& edge) {
  const Point3& p = lists.positions[edge.first];
  const Point3& q = lists.positions[edge.second];
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double mean_edge_length(const FaceLists& lists) {
  const std::vector<EdgeEnds> edges = edges_of(lists);
  double sum = 0.0;
  for (const EdgeEnds& edge : edges)
    sum += edge_length(lists, edge);
  return edges.empty() ? 0.0 : sum / static_cast<double>(edges.size());
}

bool is_closed(const FaceLists& lists) {
  std::set<std::pair<Label, Label>> sides;
  for (const Corners& face : lists.faces) {
    for (std::size_t i = 0; i < face.size(); ++i)
      sides.insert({face[i], face[(i + 1) % face.size()]});
  }
  return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
    return sides.count({side.second, side.first}) != 0;
  });
}

std::optional<FlipPlace> flip_place(const Surface& surface, const FaceLists& lists,
                                    const EdgeEnds& edge) {
  const auto [a, b] = edge;
  const auto f = surface.face_with_side(a, b);
  const auto g = surface.face_with_side(b, a);
  if (!f || !g) return std::nullopt;
  return FlipPlace{a, b, beginning_with(lists.faces[*f], a)[2],
                   beginning_with(lists.faces[*g], b)[2]};
}

int flip_gain(const Surface& surface, const FlipPlace& place) {
  const auto deviation = [&](Label v, int more) {
    return std::abs(static_cast<int>(surface.neighbours(v).size()) + more - 6);
  };
  int gain = 0;
  for (const Label end : {place.a, place.b})
    gain += deviation(end, 0) - deviation(end, -1);
  for (const Label opposite : {place.c, place.d})
    gain += deviation(opposite, 0) - deviation(opposite, 1);
  return gain;
}

void flip(FaceLists& lists, const FlipPlace& place) {
  const auto [a, b, c, d] = place;
  lists.replace({a, b, c}, {{a, d, c}});
  lists.replace({b, a, d}, {{b, c, d}});
}

int valence_deviation(const FaceLists& lists) {
  std::map<Label, int> valences;
  for (const auto& [a, b] : edges_of(lists)) {
    ++valences[a];
    ++valences[b];
  }
  int sum = 0;
  for (const auto& [label, valence] : valences)
    sum += std::abs(valence - 6);
  return sum;
}

std::optional<FaceLists> surely_resized(const FaceLists& lists, double longer, double shorter) {
  const auto split = surely_split(lists, longer);
  return split ? surely_collapsed(*split, mean_edge_length(lists), shorter) : std::nullopt;
}

std::optional<FaceLists> surely_split(const FaceLists& lists, double longer) {
  const double mean = mean_edge_length(lists);
  return split_beyond(lists, {longer * mean, longer * mean});
}

std::optional<FaceLists> surely_collapsed(const FaceLists& split, double mean, double shorter) {
  if (shorter <= 0.0) return split;
  const double later_mean = mean_edge_length(split);
  return collapsed_below(
      split, {shorter * std::min(mean, later_mean), shorter * std::max(mean, later_mean)});
}

std::optional<FaceLists> surely_flipped(const FaceLists& lists) {
  if (!is_closed(lists)) return std::nullopt;
  const Surface surface(lists);
  const std::vector<FlipPlace> all = all_flip_places(surface, lists);
  std::vector<FlipPlace> paying;
  for (const FlipPlace& place : all) {
    if (flip_gain(surface, place) <= 0) continue;
    if (surface.is_edge(place.c, place.d)) return std::nullopt;
    paying.push_back(place);
  }
  if (paying.empty()) return lists;
  if (!are_independent(all, paying)) return std::nullopt;
  FaceLists after = lists;
  for (const FlipPlace& place : paying)
    flip(after, place);
  const Surface surface_after(after);
  const std::vector<FlipPlace> all_after = all_flip_places(surface_after, after);
  const bool is_done =
      std::none_of(all_after.begin(), all_after.end(),
                   [&](const FlipPlace& place) { return flip_gain(surface_after, place) > 0; });
  if (!is_done || !are_independent(all_after, paying)) return std::nullopt;
  return after;
}

}  // namespace meshgrade
