#include "grader/cases/remesh_meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "grader/base/errors.h"
#include "grader/cases/moved_meshes.h"
#include "grader/mesh/torus_mesh.h"
#include "grader/operations/remesh_steps.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostTried = 12;    ///< limits
constexpr std::size_t kMostShaken = 200;  ///< before there is none
constexpr double kLeastGap = 1.01;        ///< between the lengths on both sides of a limit

FaceLists lists_of(const PolygonMesh& mesh) {
  return {mesh.positions, {mesh.polygons.begin(), mesh.polygons.end()}};
}

std::vector<double> sorted_shares(const FaceLists& lists) {
  const double mean = mean_edge_length(lists);
  std::vector<double> shares;
  for (const EdgeEnds& edge : edges_of(lists))
    shares.push_back(edge_length(lists, edge) / mean);
  std::sort(shares.begin(), shares.end());
  return shares;
}

/// Limits with some lengths below them, or above: those with the most come first.
std::vector<double> limits_between(std::vector<double> shares, bool from_above) {
  if (from_above) std::reverse(shares.begin(), shares.end());
  std::vector<double> limits;
  for (std::size_t i = 0; i + 1 < std::min(kMostTried, shares.size()); ++i) {
    const double limit = std::sqrt(shares[i] * shares[i + 1]);
    const double gap = std::max(shares[i], shares[i + 1]) / limit;
    if (gap * gap >= kLeastGap) limits.push_back(limit);
  }
  std::reverse(limits.begin(), limits.end());
  return limits;
}

/// Flips a third of the edges, as far as these are sides of different triangles and have
/// different ends: so no vertex loses more than one edge.
void flip_some(FaceLists& lists, Random& random) {
  const Surface surface(lists);
  std::set<std::size_t> used;
  std::set<Label> ends;
  std::set<EdgeEnds> added;
  std::vector<FlipPlace> places;
  for (const EdgeEnds& edge : edges_of(lists)) {
    if (random.below(3) != 0) continue;
    const auto place = flip_place(surface, lists, edge);
    const std::size_t f = *surface.face_with_side(place->a, place->b);
    const std::size_t g = *surface.face_with_side(place->b, place->a);
    const bool is_free = used.count(f) == 0 && used.count(g) == 0;
    if (ends.count(place->a) != 0 || ends.count(place->b) != 0) continue;
    if (!is_free || surface.is_edge(place->c, place->d)) continue;
    if (!added.insert(std::minmax(place->c, place->d)).second) continue;
    used.insert({f, g});
    ends.insert({place->a, place->b});
    places.push_back(*place);
  }
  for (const FlipPlace& place : places)
    flip(lists, place);
}

/// The limits that come first have the most edges beyond them.
std::optional<RemeshSettings> sure_factors(const PolygonMesh& mesh, WantedEdges wanted) {
  const FaceLists lists = lists_of(mesh);
  const std::vector<double> shares = sorted_shares(lists);
  std::vector<double> long_limits{kNeverLonger};
  std::vector<double> short_limits{0.0};
  if (wanted.some_long) long_limits = limits_between(shares, true);
  if (wanted.some_short) short_limits = limits_between(shares, false);
  for (const double longer : long_limits) {
    const auto split = surely_split(lists, longer);
    if (!split) continue;
    for (const double shorter : short_limits) {
      if (!surely_collapsed(*split, mean_edge_length(lists), shorter)) continue;
      RemeshSettings settings;
      settings.longer = longer;
      settings.shorter = shorter;
      return settings;
    }
  }
  return std::nullopt;
}

}  // namespace

SureMesh sure_mesh(const PolygonMesh& mesh, WantedEdges wanted, Random& random) {
  for (std::size_t i = 0; i < kMostShaken; ++i) {
    PolygonMesh tried = shaken(mesh, random);
    if (const auto settings = sure_factors(tried, wanted)) return {std::move(tried), *settings};
  }
  throw GraderError("no limits make it sure what remeshing does to a mesh of the cases");
}

PolygonMesh torus_with_flips(std::uint32_t n) {
  FaceLists lists = lists_of(torus_mesh(n, n));
  for (std::uint32_t i = 0; i + 3 < n; i += 4) {
    for (std::uint32_t j = 0; j + 3 < n; j += 4) {
      const Surface surface(lists);
      const Label here = i * n + j;
      flip(lists, *flip_place(surface, lists, std::minmax(here, here + n + 1)));
    }
  }
  return in_build_order({lists.positions, {lists.faces.begin(), lists.faces.end()}});
}

PolygonMesh crowded_torus(std::uint32_t around, std::uint32_t across, Random& random) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  PolygonMesh mesh = torus_mesh(around, across);
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = kTurn * i / around;
      const double v = kTurn * j / across;
      const double a = u + 0.35 * std::sin(u);
      const double b = v + 0.35 * std::sin(v);
      const double radius = 2.0 + 0.75 * std::cos(b);
      mesh.positions[i * across + j] = {radius * std::cos(a), 0.75 * std::sin(b),
                                        radius * std::sin(a)};
    }
  }
  FaceLists lists = lists_of(mesh);
  flip_some(lists, random);
  return in_build_order({lists.positions, {lists.faces.begin(), lists.faces.end()}});
}

PolygonMesh narrow_band(std::uint32_t n) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = kTurn * i / n;
    const double b = kTurn * (i + 0.5) / n;
    mesh.positions.push_back({std::cos(a), std::sin(a), 0.0});
    mesh.positions.push_back({std::cos(b), std::sin(b), 0.125});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = 2 * ((i + 1) % n);
    mesh.polygons.push_back({2 * i, next, 2 * i + 1});
    mesh.polygons.push_back({2 * i + 1, next, next + 1});
  }
  return in_build_order(mesh);
}

}  // namespace meshgrade
