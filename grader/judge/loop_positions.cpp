#include "grader/judge/loop_misconceptions.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

constexpr const char* kRulesMixed = "rules-mixed";

using Edge = std::pair<std::uint32_t, std::uint32_t>;

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
  Point3 smoothed(std::uint32_t v, double n, double u, const std::vector<Point3>& from) const {
    Point3 sum{};
    add(sum, from[v], 1.0 - n * u);
    for (std::uint32_t w : neighbours[v])
      add(sum, from[w], u);
    return sum;
  }

  /// 3/4 v + 1/8 (the two neighbours along the boundary), from these positions.
  Point3 smoothed_on_boundary(std::uint32_t v, const std::vector<Point3>& from) const {
    Point3 sum{};
    add(sum, from[v], 0.75);
    for (std::uint32_t w : neighbours[v]) {
      if (opposite({v, w}).size() == 1) add(sum, from[w], 0.125);
    }
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

  std::vector<Point3> positions;
  std::vector<std::vector<std::uint32_t>> neighbours;
  std::vector<bool> on_boundary;

 private:
  std::map<Edge, std::vector<std::uint32_t>> opposite_;
};

/// Builds predictions out of rules for old vertices and for edges.
class PositionPredictor {
 public:
  explicit PositionPredictor(const RefinedStep& step) : step_(step), near_(step.old) {
    for (std::size_t i = 0; i < step.origins.size(); ++i) {
      const Origin& origin = step.origins[i];
      if (origin.is_old()) place_of_old_[origin.a] = i;
      place_[std::minmax(origin.a, origin.b)] = i;
    }
  }

  std::vector<Prediction<Point3>> predict() {
    for (const RightPositions& right : step_.right) {
      right_ = &right;
      predict_edges();
      predict_old_vertices();
      if (on_boundary()) predict_boundary();
      predict_mixed_up_times();
    }
    return std::move(predictions_);
  }

 private:
  using PointOf = std::function<Point3(const Origin&)>;

  /// Old vertices and edges by these rules; where there is none, the right answer.
  void add(const char* name, const PointOf& old_rule, const PointOf& edge_rule) {
    Prediction<Point3> prediction{name, right_->points};
    for (std::size_t i = 0; i < step_.origins.size(); ++i) {
      const PointOf& rule = step_.origins[i].is_old() ? old_rule : edge_rule;
      if (rule) prediction.points[i] = rule(step_.origins[i]);
    }
    predictions_.push_back(std::move(prediction));
  }

  bool on_boundary() const {
    return std::find(near_.on_boundary.begin(), near_.on_boundary.end(), true) !=
           near_.on_boundary.end();
  }

  const Point3& right_place(std::uint32_t v) const {
    return right_->points[place_of_old_.at(v)];
  }

  bool is_inside(const Origin& edge) const { return near_.opposite(edge).size() == 2; }

  Point3 midpoint(const Origin& edge) const {
    return near_.edge_point(edge, 0.5, 0.0, near_.positions);
  }

  PointOf old_in_place() const {
    return [this](const Origin& v) { return near_.positions[v.a]; };
  }

  /// The weight of each neighbour inside, by the rule at hand.
  double weight(std::uint32_t v) const {
    return neighbour_weight(right_->rule, near_.neighbours[v].size());
  }

  void predict_edges() {
    const PointOf halves = [this](const Origin& e) { return midpoint(e); };
    add("edge-midpoints", nullptr, halves);
    add("edge-weights-swapped", nullptr, [this](const Origin& e) {
      return is_inside(e) ? near_.edge_point(e, 0.125, 0.375, near_.positions) : midpoint(e);
    });
    add("integer-division", nullptr, [](const Origin&) { return Point3{}; });
    add("not-moved", old_in_place(), halves);
  }

  /// A rule u(n) for all old vertices inside; those on a boundary stay right.
  PointOf smoothing(const std::function<double(double)>& u) const {
    return [this, u](const Origin& v) {
      if (near_.on_boundary[v.a]) return right_place(v.a);
      const double n = static_cast<double>(near_.neighbours[v.a].size());
      return near_.smoothed(v.a, n, u(n), near_.positions);
    };
  }

  void predict_old_vertices() {
    add("old-not-copied", old_in_place(), nullptr);
    add("same-weight-everywhere", smoothing([](double) { return 3.0 / 16.0; }), nullptr);
    add("no-valence-three", smoothing([](double n) { return 3.0 / (8.0 * n); }), nullptr);
    add(
        "own-weight-wrong",
        [this](const Origin& v) {
          if (near_.on_boundary[v.a]) return right_place(v.a);
          return near_.smoothed(v.a, 1.0, weight(v.a), near_.positions);
        },
        nullptr);
  }

  /// The valence of a boundary vertex is counted in edges by some, in faces by Vertex::degree.
  void predict_boundary() {
    for (std::size_t fewer : {0U, 1U}) {
      add(
          "boundary-like-inside",
          [this, fewer](const Origin& v) {
            if (!near_.on_boundary[v.a]) return right_place(v.a);
            const std::size_t n = near_.neighbours[v.a].size() - fewer;
            const double u = neighbour_weight(right_->rule, n);
            return near_.smoothed(v.a, static_cast<double>(n), u, near_.positions);
          },
          nullptr);
    }
  }

  /// Smoothing after the splits, when the neighbours are the new vertices of the edges.
  PointOf from_new_neighbours(const PointOf& place_of_edge) const {
    return [this, place_of_edge](const Origin& v) {
      if (near_.on_boundary[v.a]) return right_place(v.a);
      const double u = weight(v.a);
      Point3 sum{};
      meshgrade::add(sum, near_.positions[v.a],
                     1.0 - u * static_cast<double>(near_.neighbours[v.a].size()));
      for (std::uint32_t w : near_.neighbours[v.a])
        meshgrade::add(sum, place_of_edge({v.a, w}), u);
      return sum;
    };
  }

  void predict_mixed_up_times() {
    add("new-neighbours", from_new_neighbours([this](const Origin& e) { return midpoint(e); }),
        nullptr);
    const auto moved_edge = [this](const Origin& e) {
      return right_->points[place_.at(std::minmax(e.a, e.b))];
    };
    add("new-neighbours", from_new_neighbours(moved_edge), nullptr);
    std::vector<Point3> moved = near_.positions;
    for (const auto& [v, i] : place_of_old_)
      moved[v] = right_->points[i];
    add("edges-from-moved", nullptr, edge_rule_from(moved));
    const std::vector<Point3> in_place = moved_in_place();
    const PointOf old_rule = [&](const Origin& v) { return in_place[v.a]; };
    add("moved-in-place", old_rule, nullptr);
    add("moved-in-place", old_rule, edge_rule_from(in_place));
  }

  PointOf edge_rule_from(const std::vector<Point3>& positions) const {
    return [this, &positions](const Origin& e) {
      return is_inside(e) ? near_.edge_point(e, 0.375, 0.125, positions)
                          : near_.edge_point(e, 0.5, 0.0, positions);
    };
  }

  std::vector<Point3> moved_in_place() const {
    std::vector<Point3> moved = near_.positions;
    for (std::uint32_t v = 0; v < moved.size(); ++v) {
      const double n = static_cast<double>(near_.neighbours[v].size());
      moved[v] = near_.on_boundary[v] ? near_.smoothed_on_boundary(v, moved)
                                      : near_.smoothed(v, n, weight(v), moved);
    }
    return moved;
  }

  const RefinedStep& step_;
  Neighbourhoods near_;
  const RightPositions* right_ = nullptr;
  std::map<std::uint32_t, std::size_t> place_of_old_;
  std::map<Edge, std::size_t> place_;
  std::vector<Prediction<Point3>> predictions_;
};

/// Says which valences have which weights if every old vertex has those of one rule, but not
/// all of the same; empty if that is not so.
std::string mixture(const RefinedStep& step, const std::vector<Point3>& actual,
                    double allowed) {
  const Neighbourhoods near(step.old);
  std::vector<RightPositions> rules = step.right;
  for (const OtherRule& other : step.others) {
    if (other.name == kRulesMixed) rules.push_back(other.positions);
  }
  std::map<VertexRule, std::set<std::size_t>> valences;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    std::vector<VertexRule> fitting;
    for (const RightPositions& right : rules) {
      if (distance(right.points[i], actual[i]) <= allowed) fitting.push_back(right.rule);
    }
    if (fitting.empty()) return {};
    const bool both =
        std::find(fitting.begin(), fitting.end(), VertexRule::kLoop) != fitting.end() &&
        std::find(fitting.begin(), fitting.end(), VertexRule::kWarren) != fitting.end();
    if (!both) valences[fitting[0]].insert(near.neighbours[step.origins[i].a].size());
  }
  if (valences.size() < 2) return {};
  const auto list = [&](VertexRule rule) {
    std::vector<std::string> texts;
    for (std::size_t n : valences[rule])
      texts.push_back(std::to_string(n));
    return join(texts, ", ");
  };
  return "old vertices of valence " + list(VertexRule::kWarren) +
         " have Warren's weights, those of valence " + list(VertexRule::kLoop) +
         " have Loop's: use one rule everywhere";
}

const Misconceptions& position_misconceptions() {
  static const Misconceptions known{
      {"edge-midpoints",
       "new vertices lie in the middle of their edges: they need the weights 3/8 and 1/8"},
      {"edge-weights-swapped", "3/8 and 1/8 are swapped: 3/8 is for the ends of the edge"},
      {"integer-division",
       "weights such as 3/8 are divided as whole numbers and become 0: write 3.0 / 8.0"},
      {"not-moved",
       "the triangles are right, but no point has moved: newPosition is never computed, or "
       "never copied"},
      {"old-not-copied",
       "old vertices stay where they were: their newPosition is not copied to position (or "
       "the weight u is divided as a whole number and becomes 0)"},
      {"same-weight-everywhere", "u = 3/16 is for valence 3 only: otherwise it is 3 / (8 n)"},
      {"no-valence-three",
       "u = 3 / (8 n) is used for valence 3, too, so that 5/8 is the own weight everywhere: "
       "for valence 3 it is 3/16"},
      {"own-weight-wrong", "the old vertex's own weight is 1 - u: it must be 1 - n u"},
      {"boundary-like-inside",
       "vertices on the boundary are moved like those inside: 3/4 of their own position and "
       "1/8 of each of the two neighbours on the boundary"},
      {"new-neighbours",
       "old vertices are computed after the splits, when their neighbours are the new "
       "vertices: compute them before"},
      {"edges-from-moved",
       "edge points are computed from old vertices that have moved already"},
      {"moved-in-place",
       "old vertices are moved one after the other, so that later ones see neighbours that "
       "have moved already: compute all, then move"},
      {kRulesMixed, "two rules are mixed: use one everywhere"},
      {"other-rule", "another published rule is asked for"},
  };
  return known;
}

}  // namespace

const Misconceptions& loop_misconceptions() {
  static const Misconceptions known = [] {
    Misconceptions all = flip_misconceptions();
    all.insert(all.end(), position_misconceptions().begin(), position_misconceptions().end());
    return all;
  }();
  return known;
}

Misconceptions recognize_positions(const RefinedStep& step, const std::vector<Point3>& actual,
                                   double allowed) {
  const Misconceptions& known = position_misconceptions();
  Misconceptions likely;
  for (const OtherRule& other : step.others) {
    const bool known_already = holds(likely, other.name);
    if (known_already || !agrees(other.positions.points, actual, allowed)) continue;
    likely.push_back({other.name, other.advice});
  }
  const std::string mixed = mixture(step, actual, allowed);
  if (!mixed.empty() && !holds(likely, kRulesMixed)) likely.push_back({kRulesMixed, mixed});
  const auto predictions = PositionPredictor(step).predict();
  for (const Misconception& m : recognize(known, predictions, actual, allowed))
    likely.push_back(m);
  return likely;
}

}  // namespace meshgrade
