#include "grader/judge/loop_misconceptions.h"

#include <functional>
#include <map>
#include <utility>

#include "grader/judge/operation_model.h"
#include "grader/judge/surface_match.h"

namespace meshgrade {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using PointOf = std::function<Point3(const Origin&)>;

/// Larger meshes are not simulated: the same mistake shows on the small ones.
constexpr std::size_t kMostSimulatedFaces = 500;

void add(Point3& sum, const Point3& p, double weight) {
  for (std::size_t i = 0; i < 3; ++i)
    sum[i] += weight * p[i];
}

/// Who is next to whom in the mesh before the step.
class Neighbourhoods {
 public:
  explicit Neighbourhoods(const PolygonMesh& mesh)
      : positions(mesh.positions),
        neighbours(mesh.positions.size()),
        on_boundary(mesh.positions.size(), false) {
    for (const auto& t : mesh.polygons) {
      for (std::size_t i = 0; i < 3; ++i) {
        opposite_[std::minmax(t[i], t[(i + 1) % 3])].push_back(t[(i + 2) % 3]);
      }
    }
    for (const auto& [edge, opposite] : opposite_) {
      neighbours[edge.first].push_back(edge.second);
      neighbours[edge.second].push_back(edge.first);
      if (opposite.size() > 1) continue;
      on_boundary[edge.first] = on_boundary[edge.second] = true;
    }
  }

  const std::vector<std::uint32_t>& opposite(const Origin& edge) const {
    return opposite_.at(std::minmax(edge.a, edge.b));
  }

  /// (1 - n u) v + u (sum of the neighbours), from these positions.
  Point3 smoothed(std::uint32_t v, double u, const std::vector<Point3>& from) const {
    Point3 sum{};
    const double n = static_cast<double>(neighbours[v].size());
    add(sum, from[v], 1.0 - n * u);
    for (std::uint32_t w : neighbours[v])
      add(sum, from[w], u);
    return sum;
  }

  /// Weights for the ends of an edge and for the vertices opposite, from these positions.
  Point3 edge_point(const Origin& edge, double ends, double opposites,
                    const std::vector<Point3>& from) const {
    Point3 sum{};
    add(sum, from[edge.a], ends);
    add(sum, from[edge.b], ends);
    for (std::uint32_t v : opposite(edge))
      add(sum, from[v], opposites);
    return sum;
  }

  static double warren(std::size_t n) {
    return n == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * static_cast<double>(n));
  }

  std::vector<Point3> positions;
  std::vector<std::vector<std::uint32_t>> neighbours;
  std::vector<bool> on_boundary;

 private:
  std::map<Edge, std::vector<std::uint32_t>> opposite_;
};

/// Builds predictions out of rules for old vertices and for edges.
class PositionPredictor {
 public:
  PositionPredictor(const PolygonMesh& old, const std::vector<Origin>& origins,
                    const std::vector<std::vector<Point3>>& variants)
      : near_(old), origins_(origins), variants_(variants) {
    for (std::size_t i = 0; i < origins.size(); ++i) {
      if (origins[i].is_old()) place_of_old_[origins[i].a] = i;
      place_[std::minmax(origins[i].a, origins[i].b)] = i;
    }
  }

  std::vector<Prediction<Point3>> predict() {
    predict_edges();
    predict_old_vertices();
    predict_mixed_up_times();
    return std::move(predictions_);
  }

 private:
  /// Old vertices and edges by these rules; where there is none, the right answer.
  void add(const char* name, const char* advice, const PointOf& old_rule,
           const PointOf& edge_rule) {
    for (const std::vector<Point3>& right : variants_) {
      Prediction<Point3> prediction{{name, advice}, right};
      for (std::size_t i = 0; i < origins_.size(); ++i) {
        const PointOf& rule = origins_[i].is_old() ? old_rule : edge_rule;
        if (rule) prediction.points[i] = rule(origins_[i]);
      }
      predictions_.push_back(std::move(prediction));
    }
  }

  bool is_inside(const Origin& edge) const { return near_.opposite(edge).size() == 2; }

  Point3 midpoint(const Origin& edge) const {
    return near_.edge_point(edge, 0.5, 0.0, near_.positions);
  }

  void predict_edges() {
    const PointOf halves = [this](const Origin& e) { return midpoint(e); };
    add("edge-midpoints",
        "new vertices lie in the middle of their edges: they need the weights "
        "3/8 and 1/8",
        nullptr, halves);
    add("edge-weights-swapped", "3/8 and 1/8 are swapped: 3/8 is for the ends of the edge",
        nullptr, [this](const Origin& e) {
          return is_inside(e) ? near_.edge_point(e, 0.125, 0.375, near_.positions)
                              : midpoint(e);
        });
    add("integer-division",
        "weights such as 3/8 are divided as whole numbers and become 0: "
        "write 3.0 / 8.0",
        nullptr, [](const Origin&) { return Point3{}; });
    add("not-moved",
        "the triangles are right, but no point has moved: newPosition is never "
        "computed, or never copied",
        old_in_place(), halves);
  }

  PointOf old_in_place() const {
    return [this](const Origin& v) { return near_.positions[v.a]; };
  }

  /// A rule u(n) for all old vertices inside; those on a boundary stay right.
  PointOf smoothing(const std::function<double(std::size_t)>& u) const {
    return [this, u](const Origin& v) {
      if (near_.on_boundary[v.a]) return variants_[0][place_of_old_.at(v.a)];
      return near_.smoothed(v.a, u(near_.neighbours[v.a].size()), near_.positions);
    };
  }

  void predict_old_vertices() {
    add("old-not-copied",
        "old vertices stay where they were: their newPosition is not copied "
        "to position (or the weight u is divided as a whole number and becomes 0)",
        old_in_place(), nullptr);
    add("same-weight-everywhere", "u = 3/16 is for valence 3 only: otherwise it is 3 / (8 n)",
        smoothing([](std::size_t) { return 3.0 / 16.0; }), nullptr);
    add("no-valence-three", "u = 3 / (8 n) is used for valence 3, too: there it is 3/16",
        smoothing([](std::size_t n) { return 3.0 / (8.0 * static_cast<double>(n)); }), nullptr);
    add(
        "own-weight-wrong", "the old vertex's own weight is 1 - u: it must be 1 - n u",
        [this](const Origin& v) {
          const double u = Neighbourhoods::warren(near_.neighbours[v.a].size());
          const double n = static_cast<double>(near_.neighbours[v.a].size());
          Point3 p = near_.smoothed(v.a, u, near_.positions);
          meshgrade::add(p, near_.positions[v.a], (n - 1.0) * u);
          return p;
        },
        nullptr);
    add(
        "boundary-like-inside", "vertices on the boundary are moved like those inside",
        [this](const Origin& v) {
          const double u = Neighbourhoods::warren(near_.neighbours[v.a].size());
          if (near_.on_boundary[v.a]) return near_.smoothed(v.a, u, near_.positions);
          return variants_[0][place_of_old_.at(v.a)];
        },
        nullptr);
  }

  void predict_mixed_up_times() {
    add(
        "new-neighbours",
        "old vertices are computed after the splits, when their neighbours are "
        "the new vertices: compute them before",
        [this](const Origin& v) {
          Point3 sum{};
          const double u = Neighbourhoods::warren(near_.neighbours[v.a].size());
          const double n = static_cast<double>(near_.neighbours[v.a].size());
          meshgrade::add(sum, near_.positions[v.a], 1.0 - n * u);
          for (std::uint32_t w : near_.neighbours[v.a]) {
            meshgrade::add(sum, variants_[0][place_.at(std::minmax(v.a, w))], u);
          }
          return sum;
        },
        nullptr);
    add("edges-from-moved",
        "edge points are computed from old vertices that have moved already", nullptr,
        [this, moved = moved_rightly()](const Origin& e) {
          return is_inside(e) ? near_.edge_point(e, 0.375, 0.125, moved)
                              : near_.edge_point(e, 0.5, 0.0, moved);
        });
    add(
        "moved-in-place",
        "old vertices are moved one after the other, so that later ones see "
        "neighbours that have moved already: compute all, then move",
        [moved = moved_in_place()](const Origin& v) { return moved[v.a]; }, nullptr);
  }

  std::vector<Point3> moved_rightly() const {
    std::vector<Point3> moved = near_.positions;
    for (const auto& [v, i] : place_of_old_)
      moved[v] = variants_[0][i];
    return moved;
  }

  std::vector<Point3> moved_in_place() const {
    std::vector<Point3> moved = near_.positions;
    for (std::uint32_t v = 0; v < moved.size(); ++v) {
      moved[v] = near_.smoothed(v, Neighbourhoods::warren(near_.neighbours[v].size()), moved);
    }
    return moved;
  }

  Neighbourhoods near_;
  const std::vector<Origin>& origins_;
  const std::vector<std::vector<Point3>>& variants_;
  std::map<std::uint32_t, std::size_t> place_of_old_;
  std::map<Edge, std::size_t> place_;
  std::vector<Prediction<Point3>> predictions_;
};

/// All old edges split, with the new edges noted by kind.
struct SplitMesh {
  MeshDump mesh;
  std::vector<Ref> halves;    ///< both halves of every old edge
  std::vector<Ref> crossing;  ///< the new edges between a new vertex and the one opposite
};

SplitMesh split_all(const MeshDump& before) {
  SplitMesh split{before, {}, {}};
  for (Ref e = 0; e < before.edges.size(); ++e) {
    if (before.edges[e].live == 0) continue;
    const Ref first_new = static_cast<Ref>(split.mesh.edges.size());
    model_split(split.mesh, e);
    split.halves.push_back(e);
    split.halves.push_back(first_new);
    for (Ref n = first_new + 1; n < split.mesh.edges.size(); ++n)
      split.crossing.push_back(n);
  }
  return split;
}

MeshDump flip_each(MeshDump mesh, const std::vector<Ref>& edges) {
  for (Ref e : edges) {
    if (!is_boundary_edge(mesh, e)) model_flip(mesh, e);
  }
  return mesh;
}

/// Flips every new edge directly after the split that made it.
MeshDump flip_at_once(const MeshDump& before) {
  MeshDump mesh = before;
  for (Ref e = 0; e < before.edges.size(); ++e) {
    if (before.edges[e].live == 0) continue;
    const Ref first_new = static_cast<Ref>(mesh.edges.size());
    model_split(mesh, e);
    const Ref end = static_cast<Ref>(mesh.edges.size());
    for (Ref n = first_new + 1; n < end; ++n) {
      if (!is_boundary_edge(mesh, n)) model_flip(mesh, n);
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

}  // namespace

std::vector<Misconception> recognize_positions(const PolygonMesh& old,
                                               const std::vector<Origin>& origins,
                                               const std::vector<std::vector<Point3>>& variants,
                                               const std::vector<Prediction<Point3>>& others,
                                               const std::vector<Point3>& actual,
                                               double allowed) {
  std::vector<Misconception> likely = recognize(others, actual, allowed);
  const auto predictions = PositionPredictor(old, origins, variants).predict();
  for (const Misconception& m : recognize(predictions, actual, allowed)) {
    const bool known = !likely.empty() && likely.back().name == m.name;
    if (!known) likely.push_back(m);
  }
  return likely;
}

std::vector<Misconception> recognize_connectivity(const MeshDump& before,
                                                  const MeshDump& actual) {
  if (before.faces.size() > kMostSimulatedFaces) return {};
  const SplitMesh split = split_all(before);
  if (is_same_surface(split.mesh, actual)) {
    return {{"none-flipped", "all edges are split, but no new edge is flipped"}};
  }
  if (is_same_surface(flip_each(split.mesh, split.halves), actual)) {
    return {
        {"wrong-pair-flipped",
         "the two halves of the old edges are flipped instead of the edges across: isNew is "
         "set on the wrong pair in splitEdge"}};
  }
  if (is_same_surface(flip_each(split.mesh, split.crossing), actual)) {
    return {{"all-flipped",
             "every new edge is flipped: only those between an old and a new vertex may be"}};
  }
  if (is_same_surface(flip_at_once(before), actual)) {
    return {{"flipped-too-early", "edges are flipped before all splits are done"}};
  }
  return {};
}

}  // namespace meshgrade
