#include "grader/judge/loop_divisions.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "grader/base/text.h"
#include "grader/judge/loop_neighbourhoods.h"

namespace meshgrade {
namespace {

/// Some of the divisions of a kind of points: bit k is set if division k comes out as 0.
using Zeros = std::bitset<4>;

/// A division in a weight, and how to write it.
struct Division {
  const char* weight;   ///< "3/8"
  const char* written;  ///< "3.0 / 8.0"
};

/// Points that are computed by the same formula.
struct PointKind {
  std::vector<Division> divisions;
  std::function<bool(const Origin&)> holds;
  std::function<Point3(const Origin&, const Zeros&)> point;
};

PointKind edges_inside(const Neighbourhoods& near) {
  return {{{"3/8", "3.0 / 8.0"}, {"1/8", "1.0 / 8.0"}},
          [&](const Origin& o) { return !o.is_old() && near.opposite(o).size() == 2; },
          [&](const Origin& e, const Zeros& zero) {
            return near.edge_point(e, zero[0] ? 0.0 : 0.375, zero[1] ? 0.0 : 0.125,
                                   near.positions);
          }};
}

PointKind edges_on_boundary(const Neighbourhoods& near) {
  return {{{"1/2", "1.0 / 2.0"}},
          [&](const Origin& o) { return !o.is_old() && near.opposite(o).size() == 1; },
          [&](const Origin& e, const Zeros& zero) {
            return near.edge_point(e, zero[0] ? 0.0 : 0.5, 0.0, near.positions);
          }};
}

PointKind vertices_on_boundary(const Neighbourhoods& near) {
  return {{{"3/4", "3.0 / 4.0"}, {"1/8", "1.0 / 8.0"}},
          [&](const Origin& o) { return o.is_old() && near.on_boundary[o.a]; },
          [&](const Origin& v, const Zeros& zero) {
            Point3 sum{};
            add_weighted(sum, near.positions[v.a], zero[0] ? 0.0 : 0.75);
            for (std::uint32_t w : near.neighbours[v.a]) {
              const bool along = near.opposite({v.a, w}).size() == 1;
              if (along && !zero[1]) add_weighted(sum, near.positions[w], 0.125);
            }
            return sum;
          }};
}

bool is_inside(const Neighbourhoods& near, const Origin& o) {
  return o.is_old() && !near.on_boundary[o.a];
}

/// 3/16 for three neighbours, otherwise 3 / (8 n).
PointKind vertices_by_warren(const Neighbourhoods& near) {
  return {{{"3/16", "3.0 / 16.0"}, {"3 / (8 n)", "3.0 / (8.0 * n)"}},
          [&](const Origin& o) { return is_inside(near, o); },
          [&](const Origin& v, const Zeros& zero) {
            const std::size_t n = near.neighbours[v.a].size();
            const double u =
                zero[n == 3 ? 0 : 1] ? 0.0 : neighbour_weight(VertexRule::kWarren, n);
            return near.smoothed(v.a, static_cast<double>(n), u, near.positions);
          }};
}

/// 1/n (5/8 - (3/8 + 1/4 cos(2 pi / n))^2): Loop 1987.
PointKind vertices_by_loop(const Neighbourhoods& near) {
  return {{{"1/n", "1.0 / n"},
           {"5/8", "5.0 / 8.0"},
           {"3/8 in the weight of old vertices", "3.0 / 8.0"},
           {"1/4", "1.0 / 4.0"}},
          [&](const Origin& o) { return is_inside(near, o); },
          [&](const Origin& v, const Zeros& zero) {
            const auto n = static_cast<double>(near.neighbours[v.a].size());
            const double own = zero[1] ? 0.0 : 0.625;
            const double c = (zero[2] ? 0.0 : 0.375) +
                             (zero[3] ? 0.0 : 0.25) * std::cos(2.0 * std::numbers::pi / n);
            return near.smoothed(v.a, n, zero[0] ? 0.0 : (own - c * c) / n, near.positions);
          }};
}

/// The fewest divisions of a kind whose loss explains all of its points; nothing if none does.
std::optional<Zeros> fewest(const PointKind& kind, const RefinedStep& step,
                            const std::vector<Point3>& actual, double allowed) {
  std::vector<Zeros> possible;
  for (unsigned long bits = 0; bits < 1UL << kind.divisions.size(); ++bits)
    possible.emplace_back(bits);
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const Origin& origin = step.origins[i];
    if (!kind.holds(origin)) continue;
    const auto differs = [&](const Zeros& zero) {
      return !(distance(kind.point(origin, zero), actual[i]) <= allowed);
    };
    possible.erase(std::remove_if(possible.begin(), possible.end(), differs), possible.end());
  }
  const auto smallest =
      std::min_element(possible.begin(), possible.end(),
                       [](const Zeros& a, const Zeros& b) { return a.count() < b.count(); });
  if (smallest == possible.end()) return std::nullopt;
  return *smallest;
}

std::string advice(const std::vector<Division>& lost) {
  std::vector<std::string> weights;
  for (const Division& division : lost)
    weights.emplace_back(division.weight);
  std::sort(weights.begin(), weights.end());
  weights.erase(std::unique(weights.begin(), weights.end()), weights.end());
  const bool one = weights.size() == 1;
  return join(weights, " and ") +
         (one ? " is divided as whole numbers and becomes 0: write "
              : " are divided as whole numbers and become 0: write ") +
         lost.front().written;
}

/// What is lost if old vertices inside have the weights of this rule; nothing if divisions do
/// not explain all points.
std::optional<Misconception> explain_step(const RefinedStep& step, const RightPositions& right,
                                          const std::vector<Point3>& actual, double allowed) {
  const Neighbourhoods near(step.old);
  const bool loops = right.rule == VertexRule::kLoop;
  const PointKind inside = loops ? vertices_by_loop(near) : vertices_by_warren(near);
  std::vector<Division> lost;
  std::size_t lost_elsewhere = 0;
  for (const PointKind& kind :
       {edges_inside(near), edges_on_boundary(near), vertices_on_boundary(near), inside}) {
    lost_elsewhere = lost.size();
    const std::optional<Zeros> zero = fewest(kind, step, actual, allowed);
    if (!zero.has_value()) return std::nullopt;
    for (std::size_t k = 0; k < kind.divisions.size(); ++k) {
      if ((*zero)[k]) lost.push_back(kind.divisions[k]);
    }
  }
  if (lost.empty()) return std::nullopt;
  return Misconception{lost_elsewhere == 0 ? "integer-weight" : "integer-division",
                       advice(lost)};
}

}  // namespace

Misconceptions recognize_divisions(const RefinedStep& step, const std::vector<Point3>& actual,
                                   double allowed) {
  for (const RightPositions& right : step.right) {
    if (const auto explained = explain_step(step, right, actual, allowed)) return {*explained};
  }
  return {};
}

}  // namespace meshgrade
