#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "grader/judge/loop_misconceptions.h"
#include "grader/judge/operation_model.h"
#include "grader/judge/point_compare.h"
#include "grader/judge/surface_match.h"

namespace meshgrade {
namespace {

/// Larger meshes are not simulated: the same mistake shows on the small ones.
constexpr std::size_t kMostSimulatedFaces = 500;

/// An edge after all old edges were split, or after one was.
struct SplitEdge {
  Ref edge;
  bool is_half;  ///< one half of an old edge; else it joins the new vertex with one opposite
  Ref far_end;   ///< of a half the old vertex, else the vertex opposite
};

/// In which order a split makes its edges. Flips are done in the order of the list of edges,
/// and where they spoil the mesh their order matters.
enum class SplitOrder { kLeftFirst, kRightFirst };

/// Splits an edge. @return the edges that were made, in the order of their making
std::vector<SplitEdge> split_edge(MeshDump& mesh, Ref edge, SplitOrder order) {
  const Diamond diamond = diamond_of(mesh, edge);
  const Ref first_new = static_cast<Ref>(mesh.edges.size());
  model_split(mesh, edge);
  std::vector<SplitEdge> made{{first_new, true, diamond.c}, {first_new + 1, false, diamond.a}};
  if (diamond.d != kUnsetRef) made.push_back({first_new + 2, false, diamond.d});
  if (order == SplitOrder::kRightFirst) std::reverse(made.begin() + 1, made.end());
  return made;
}

struct SplitMesh {
  MeshDump mesh;
  std::vector<SplitEdge> edges;  ///< in the order of a student's list: old ones come first
};

std::vector<Ref> live_edges(const MeshDump& mesh) {
  std::vector<Ref> edges;
  for (Ref e = 0; e < mesh.edges.size(); ++e) {
    if (mesh.edges[e].live != 0) edges.push_back(e);
  }
  return edges;
}

SplitMesh split_all(const MeshDump& before, SplitOrder order) {
  SplitMesh split{before, {}};
  std::vector<SplitEdge> made;
  for (Ref e : live_edges(before)) {
    split.edges.push_back({e, true, diamond_of(split.mesh, e).b});
    const std::vector<SplitEdge> more = split_edge(split.mesh, e, order);
    made.insert(made.end(), more.begin(), more.end());
  }
  split.edges.insert(split.edges.end(), made.begin(), made.end());
  return split;
}

using EdgeChoice = std::function<bool(const SplitEdge&)>;

void flip_inner(MeshDump& mesh, Ref edge) {
  if (!is_boundary_edge(mesh, edge)) model_flip(mesh, edge);
}

MeshDump flip_after_all(SplitMesh split, const EdgeChoice& is_flipped) {
  for (const SplitEdge& e : split.edges) {
    if (is_flipped(e)) flip_inner(split.mesh, e.edge);
  }
  return std::move(split.mesh);
}

/// Flips directly after the split that made the edge.
MeshDump flip_at_once(const MeshDump& before, SplitOrder order, const EdgeChoice& is_flipped) {
  MeshDump mesh = before;
  for (Ref e : live_edges(before)) {
    for (const SplitEdge& made : split_edge(mesh, e, order)) {
      if (is_flipped(made)) flip_inner(mesh, made.edge);
    }
  }
  return mesh;
}

bool is_same_surface(const MeshDump& predicted, const MeshDump& actual) {
  std::vector<Ref> starts;
  for (Ref h = 0; h < predicted.halfedges.size(); ++h)
    starts.push_back(h);
  SurfaceMatch match(predicted);
  const auto candidates = [&](Ref from) {
    std::vector<Ref> list;
    for (Ref h = 0; h < actual.halfedges.size(); ++h) {
      const bool same_vertex = actual.halfedges[h].vertex == predicted.halfedges[from].vertex;
      if (actual.halfedges[h].live != 0 && same_vertex) list.push_back(h);
    }
    return list;
  };
  return match_surfaces(predicted, actual, starts, candidates, match);
}

/// What a misconception flips, given the numbers of the first new vertex of this step and of
/// the first one that an earlier step has made.
struct FlipMistake {
  const char* name;
  bool at_once;
  bool (*is_flipped)(const SplitEdge& edge, Ref first_new, Ref first_marked);
};

constexpr FlipMistake kFlipMistakes[] = {
    {"none-flipped", false, [](const SplitEdge&, Ref, Ref) { return false; }},
    {"all-flipped", false, [](const SplitEdge& e, Ref, Ref) { return !e.is_half; }},
    {"new-to-new-flipped", false,
     [](const SplitEdge& e, Ref first_new, Ref) {
       return !e.is_half && e.far_end >= first_new;
     }},
    {"wrong-pair-marked", false, [](const SplitEdge& e, Ref, Ref) { return e.is_half; }},
    {"old-halves-flipped", false,
     [](const SplitEdge& e, Ref first_new, Ref) { return e.is_half || e.far_end < first_new; }},
    {"marks-not-reset", false,
     [](const SplitEdge& e, Ref, Ref marked) { return !e.is_half && e.far_end < marked; }},
    {"flipped-too-early", true,
     [](const SplitEdge& e, Ref first_new, Ref) {
       return !e.is_half && e.far_end < first_new;
     }},
    {"flipped-too-early", true, [](const SplitEdge& e, Ref, Ref) { return !e.is_half; }},
};

bool explains(const FlipMistake& mistake, SplitOrder order, const MeshDump& before,
              const MeshDump& actual, Ref first_marked) {
  const Ref first_new = static_cast<Ref>(before.vertices.size());
  const EdgeChoice is_flipped = [&](const SplitEdge& e) {
    return mistake.is_flipped(e, first_new, first_marked);
  };
  const MeshDump predicted = mistake.at_once
                                 ? flip_at_once(before, order, is_flipped)
                                 : flip_after_all(split_all(before, order), is_flipped);
  return is_same_surface(predicted, actual);
}

/// How many inner edges are longer than all others of their two triangles.
std::size_t count_diagonals(const PolygonMesh& mesh) {
  const auto length = [&](std::uint32_t a, std::uint32_t b) {
    return distance(mesh.positions[a], mesh.positions[b]);
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> longest_in;
  for (const auto& t : mesh.polygons) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double own = length(t[i], t[(i + 1) % 3]);
      constexpr double kClearly = 1.0 + 1e-9;
      if (own > kClearly * length(t[(i + 1) % 3], t[(i + 2) % 3]) &&
          own > kClearly * length(t[(i + 2) % 3], t[i])) {
        ++longest_in[std::minmax(t[i], t[(i + 1) % 3])];
      }
    }
  }
  return static_cast<std::size_t>(std::count_if(
      longest_in.begin(), longest_in.end(), [](const auto& edge) { return edge.second == 2; }));
}

}  // namespace

Misconceptions recognize_counts(const PolygonMesh& old, const Counts& before,
                                const Counts& actual) {
  const auto named = [](const char* name) -> Misconceptions {
    return {find_misconception(flip_misconceptions(), name)};
  };
  if (actual == before) return named("none-split");
  // Splitting an inner edge adds a vertex, three edges and two faces.
  const std::size_t split = count_diagonals(old);
  const std::size_t edges = before.edges + 3 * split;
  const std::size_t faces = before.faces + 2 * split;
  const bool split_first = split > 0 && actual.vertices == before.vertices + split + edges &&
                           actual.edges == 2 * edges + 3 * faces && actual.faces == 4 * faces;
  return split_first ? named("diagonals-split-first") : Misconceptions();
}

const Misconceptions& flip_misconceptions() {
  static const Misconceptions known{
      {"none-flipped",
       "all edges are split, but no new edge is flipped: does splitEdge set "
       "isNew?"},
      {"all-flipped",
       "every new edge is flipped: only those between an old and a new vertex may be"},
      {"new-to-new-flipped",
       "the new edges between two new vertices are flipped: it must be those between an old "
       "and a new vertex"},
      {"wrong-pair-marked",
       "the two halves of the old edges are flipped instead of the edges across: isNew is "
       "set on the wrong pair in splitEdge"},
      {"old-halves-flipped",
       "every edge between an old and a new vertex is flipped, the halves of the old edges as "
       "well: only edges with isNew may be"},
      {"marks-not-reset",
       "isNew of the level before is still set: at the start, no vertex and no edge is new"},
      {"flipped-too-early", "edges are flipped before all splits are done"},
      {"none-split",
       "no edge is split at all: the mesh has as many triangles as before. Is the loop over "
       "the "
       "old edges ever entered?"},
      {"diagonals-split-first",
       "there are as many triangles as if the diagonals had been split before: upsample "
       "subdivides the mesh that it is given. Splitting a cube's diagonals, so that it stays "
       "symmetric, is for your write-up"},
  };
  return known;
}

Misconceptions recognize_connectivity(const MeshDump& before, const MeshDump& actual,
                                      Ref first_marked) {
  Misconceptions likely;
  if (before.faces.size() > kMostSimulatedFaces) return likely;
  for (const FlipMistake& mistake : kFlipMistakes) {
    for (SplitOrder order : {SplitOrder::kLeftFirst, SplitOrder::kRightFirst}) {
      if (!holds(likely, mistake.name) &&
          explains(mistake, order, before, actual, first_marked)) {
        likely.push_back(find_misconception(flip_misconceptions(), mistake.name));
      }
    }
  }
  return likely;
}

}  // namespace meshgrade
