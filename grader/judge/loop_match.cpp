#include "grader/judge/loop_match.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "grader/judge/point_compare.h"
#include "grader/judge/surface_match.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostCandidates = 64;

using Preferred = std::function<bool(Ref expected_vertex, Ref vertex)>;

/// Half-edges of `mesh` that may be the half-edge `from` of the level: the preferred ones, then
/// the nearest.
std::vector<Ref> candidates(const Level& level, const MeshDump& mesh, Ref from,
                            const Preferred& preferred) {
  const HalfedgeRecord& h = level.surface.halfedges[from];
  const Ref end = level.surface.halfedges[h.twin].vertex;
  const std::vector<Point3>& points = level.by_variant.begin()->second.positions;
  std::vector<std::pair<std::pair<bool, double>, Ref>> ranked;
  for (Ref g = 0; g < mesh.halfedges.size(); ++g) {
    const HalfedgeRecord& other = mesh.halfedges[g];
    if (other.live == 0) continue;
    const double off =
        distance(points[h.vertex], mesh.vertices[other.vertex].position) +
        distance(points[end], mesh.vertices[mesh.halfedges[other.twin].vertex].position);
    ranked.push_back({{!preferred(h.vertex, other.vertex), off}, g});
  }
  const std::size_t kept = std::min(kMostCandidates, ranked.size());
  std::partial_sort(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(kept),
                    ranked.end());
  std::vector<Ref> list;
  for (std::size_t i = 0; i < kept; ++i)
    list.push_back(ranked[i].second);
  return list;
}

/// The half-edges of the level that start at an old vertex, or that join two new ones.
std::vector<Ref> starts(const Level& level, bool at_old) {
  const auto is_old = [&](Ref h) {
    return level.origins[level.surface.halfedges[h].vertex].is_old();
  };
  std::vector<Ref> list;
  for (Ref h = 0; h < level.surface.halfedges.size(); ++h) {
    const bool starts_there = at_old == is_old(h);
    if (starts_there && (at_old || !is_old(level.surface.halfedges[h].twin))) list.push_back(h);
  }
  return list;
}

/// Old vertices have the numbers that they had. Empty if there is no such match.
std::vector<Ref> match_by_numbers(const Level& level, const std::vector<Ref>& old_to_mine,
                                  const MeshDump& mesh) {
  SurfaceMatch match(level.surface);
  for (std::size_t v = 0; v < level.origins.size(); ++v) {
    const Origin& origin = level.origins[v];
    if (origin.is_old()) match.vertex[v] = old_to_mine[origin.a];
  }
  const auto has_its_number = [&](Ref expected, Ref vertex) {
    return match.vertex[expected] == vertex;
  };
  const auto list = [&](Ref h) { return candidates(level, mesh, h, has_its_number); };
  const bool found = match_surfaces(level.surface, mesh, starts(level, true), list, match);
  return found ? match.vertex : std::vector<Ref>();
}

/// Starts between new vertices, whose positions are the same by all rules. Empty if there is
/// no match.
std::vector<Ref> match_by_positions(const Level& level, const MeshDump& mesh) {
  SurfaceMatch match(level.surface);
  const auto list = [&](Ref h) {
    return candidates(level, mesh, h, [](Ref, Ref) { return false; });
  };
  const bool found = match_surfaces(level.surface, mesh, starts(level, false), list, match);
  return found ? match.vertex : std::vector<Ref>();
}

/// By the variant that fits best.
std::size_t count_wrong(const Level& level, const std::vector<Ref>& match, const MeshDump& mesh,
                        const std::vector<LocalScale>& scales) {
  if (match.empty()) return std::numeric_limits<std::size_t>::max();
  const std::vector<Point3> actual = matched_points(match, mesh);
  std::size_t fewest = actual.size();
  for (const auto& [name, polygons] : level.by_variant)
    fewest = std::min(fewest, count_wrong(polygons, actual, scales));
  return fewest;
}

}  // namespace

std::vector<Point3> matched_points(const std::vector<Ref>& match, const MeshDump& mesh) {
  std::vector<Point3> points;
  for (Ref v : match)
    points.push_back(mesh.vertices[v].position);
  return points;
}

std::size_t count_wrong(const PolygonMesh& right, const std::vector<Point3>& actual,
                        const std::vector<LocalScale>& scales) {
  std::size_t wrong = 0;
  for (std::size_t v = 0; v < actual.size(); ++v)
    wrong += distance(right.positions[v], actual[v]) <= scales[v].allowed ? 0 : 1;
  return wrong;
}

std::vector<Ref> match_level(const Level& level, const std::vector<Ref>& old_to_mine,
                             const MeshDump& mesh, const std::vector<LocalScale>& scales) {
  std::vector<Ref> by_numbers = match_by_numbers(level, old_to_mine, mesh);
  const std::size_t wrong = count_wrong(level, by_numbers, mesh, scales);
  if (wrong == 0) return by_numbers;
  std::vector<Ref> by_positions = match_by_positions(level, mesh);
  return count_wrong(level, by_positions, mesh, scales) < wrong ? by_positions : by_numbers;
}

}  // namespace meshgrade
