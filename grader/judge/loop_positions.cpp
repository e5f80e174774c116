#include "grader/judge/loop_misconceptions.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "grader/base/text.h"
#include "grader/judge/loop_divisions.h"
#include "grader/judge/loop_neighbourhoods.h"

namespace meshgrade {
namespace {

constexpr const char* kRulesMixed = "rules-mixed";

/// Weights that are tuned for valences from 3 to 12: Barthe and Kobbelt, "Subdivision scheme
/// tuning around extraordinary vertices", Computer Aided Geometric Design 21, 2004, with the
/// numbers of MeshLab's filter.
struct TunedWeights {
  const char* name;
  std::array<double, 10> own;        ///< of an old vertex itself
  std::array<double, 10> irregular;  ///< edge point: of the end that has not six neighbours
  std::array<double, 10> opposite;   ///< edge point: of each vertex opposite

  bool knows(std::size_t valence) const { return valence >= 3 && valence <= 12; }
};

constexpr TunedWeights kTunedForRegularity{
    "tuned-for-regularity",
    {.32517, .49954, .59549, .625, .63873, .64643, .65127, .67358, .68678, .69908},
    {.15658, .25029, .34547, .375, .38877, .39644, .40132, .42198, .43423, .44579},
    {.14427, .12524, .11182, .125, .14771, .1768, .21092, .20354, .20505, .19828}};

constexpr TunedWeights kTunedForContinuity{
    "tuned-for-continuity",
    {.32517, .50033, .59464, .625, .63903, .67821, .6866, .69248, .69678, .70014},
    {.15658, .26721, .33539, .375, .36909, .25579, .2521, .24926, .24706, .2452},
    {.14427, .12495, .11252, .125, .14673, .16074, .18939, .2222, .25894, .29934}};

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
      if (on_boundary()) {
        predict_boundary();
      } else {
        predict_tuned_weights();
      }
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

  PointOf old_in_place_inside() const {
    return [this](const Origin& v) {
      return near_.on_boundary[v.a] ? right_place(v.a) : near_.positions[v.a];
    };
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
    const PointOf zero = [](const Origin&) { return Point3{}; };
    add("new-position-not-set", nullptr, zero);
    add("not-moved", old_in_place(), halves);
  }

  /// The weight of an old vertex itself: 1 - n u, or as if each neighbour had u / 2.
  enum class Own { kRest, kAsIfOnce };

  /// A rule u(n) for all old vertices inside; those on a boundary stay right.
  PointOf smoothing(const std::function<double(double)>& u, Own own = Own::kRest) const {
    return [this, u, own](const Origin& v) {
      if (near_.on_boundary[v.a]) return right_place(v.a);
      const double n = static_cast<double>(near_.neighbours[v.a].size());
      const double counted = own == Own::kRest ? n : 0.5 * n;
      return near_.smoothed(v.a, counted, u(n), near_.positions);
    };
  }

  void predict_old_vertices() {
    add("old-not-copied", old_in_place(), nullptr);
    add("integer-weight", old_in_place_inside(), nullptr);
    add(
        "integer-three-sixteenths",
        [this](const Origin& v) {
          const bool of_three = near_.neighbours[v.a].size() == 3 && !near_.on_boundary[v.a];
          return of_three ? near_.positions[v.a] : right_place(v.a);
        },
        nullptr);
    add("neighbours-twice",
        smoothing(
            [this](double n) {
              return 2.0 * neighbour_weight(right_->rule, static_cast<std::size_t>(n));
            },
            Own::kAsIfOnce),
        nullptr);
    add("same-weight-everywhere", smoothing([](double) { return 3.0 / 16.0; }), nullptr);
    if (has_inner_valence(3))  // elsewhere it is the whole of another published rule
      add("no-valence-three", smoothing([](double n) { return 3.0 / (8.0 * n); }), nullptr);
    add(
        "own-weight-wrong",
        [this](const Origin& v) {
          if (near_.on_boundary[v.a]) return right_place(v.a);
          return near_.smoothed(v.a, 1.0, weight(v.a), near_.positions);
        },
        nullptr);
  }

  bool has_inner_valence(std::size_t valence) const {
    for (std::size_t v = 0; v < near_.neighbours.size(); ++v) {
      if (near_.neighbours[v].size() == valence && !near_.on_boundary[v]) return true;
    }
    return false;
  }

  /// The valence of a boundary vertex is counted in edges by some, in faces by Vertex::degree.
  void predict_boundary() {
    add(
        "boundary-vertices-counted",
        [this](const Origin& v) {
          return near_.on_boundary[v.a] ? near_.smoothed_by_boundary_vertices(v.a)
                                        : right_place(v.a);
        },
        nullptr);
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

  /// The two other weightings of MeshLab, of closed meshes: an edge has weights of its own
  /// where one of its ends has six neighbours and the other has not.
  void predict_tuned_weights() {
    for (const TunedWeights* tuned : {&kTunedForRegularity, &kTunedForContinuity}) {
      add(tuned->name, smoothing([tuned](double n) {
            const auto k = static_cast<std::size_t>(n);
            return tuned->knows(k) ? (1.0 - tuned->own[k - 3]) / n
                                   : neighbour_weight(VertexRule::kLoop, k);
          }),
          [this, tuned](const Origin& e) { return tuned_edge_point(*tuned, e); });
    }
  }

  Point3 tuned_edge_point(const TunedWeights& tuned, const Origin& e) const {
    const auto valence = [&](std::uint32_t v) { return near_.neighbours[v].size(); };
    const bool first_regular = valence(e.a) == 6;
    const std::uint32_t regular = first_regular ? e.a : e.b;
    const std::uint32_t other = first_regular ? e.b : e.a;
    const std::size_t k = valence(other);
    if (valence(regular) != 6 || !tuned.knows(k)) {
      return near_.edge_point(e, 0.375, 0.125, near_.positions);
    }
    const double opposites = tuned.opposite[k - 3];
    const double irregular = tuned.irregular[k - 3];
    Point3 sum = near_.edge_point(e, 0.0, opposites, near_.positions);
    add_weighted(sum, near_.positions[other], irregular);
    add_weighted(sum, near_.positions[regular], 1.0 - irregular - 2.0 * opposites);
    return sum;
  }

  /// Smoothing after the splits, when the neighbours are the new vertices of the edges.
  PointOf from_new_neighbours(const PointOf& place_of_edge) const {
    return [this, place_of_edge](const Origin& v) {
      if (near_.on_boundary[v.a]) return right_place(v.a);
      const double u = weight(v.a);
      Point3 sum{};
      add_weighted(sum, near_.positions[v.a],
                   1.0 - u * static_cast<double>(near_.neighbours[v.a].size()));
      for (std::uint32_t w : near_.neighbours[v.a])
        add_weighted(sum, place_of_edge({v.a, w}), u);
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
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> place_;
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

}  // namespace

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
  for (const Misconception& m : recognize_divisions(step, actual, allowed)) {
    const bool whole_weights =
        holds(likely, "integer-weight") || holds(likely, "integer-three-sixteenths");
    if (!whole_weights) likely.push_back(m);
  }
  return likely;
}

}  // namespace meshgrade
