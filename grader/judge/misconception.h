#pragma once

// What a wrong answer probably comes from. Every known misconception predicts the numbers that
// it would give; it is named only when the student's numbers are these.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "grader/base/errors.h"
#include "grader/judge/point_compare.h"

namespace meshgrade {

struct Misconception {
  std::string name;    ///< short, as in the tests: "t-swapped"
  std::string advice;  ///< a sentence for the student
};

/// All that the judge of an exercise can name. tests/submissions has a submission for each.
using Misconceptions = std::vector<Misconception>;

/// @throws GraderError if the list does not have this name
inline const Misconception& find_misconception(const Misconceptions& known,
                                               const std::string& name) {
  for (const Misconception& m : known) {
    if (m.name == name) return m;
  }
  throw GraderError("the list of misconceptions lacks \"" + name + "\"");
}

inline bool holds(const Misconceptions& list, const std::string& name) {
  return std::any_of(list.begin(), list.end(),
                     [&](const Misconception& m) { return m.name == name; });
}

/// The points that a misconception gives in place of the expected ones.
template <class Point>
struct Prediction {
  std::string misconception;  ///< its name
  std::vector<Point> points;
};

/// True if the points are the same, to `allowed` (a length). A point that is not finite agrees
/// with every other such point: no misconception tells them apart.
template <class Point>
bool agrees(const std::vector<Point>& predicted, const std::vector<Point>& actual,
            double allowed) {
  const auto is_finite = [](const Point& p) {
    return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
  };
  return std::equal(predicted.begin(), predicted.end(), actual.begin(), actual.end(),
                    [&](const Point& p, const Point& a) {
                      if (!is_finite(p) || !is_finite(a)) return is_finite(p) == is_finite(a);
                      return distance(p, a) <= allowed;
                    });
}

/// The misconceptions whose predictions agree with `actual` everywhere, each once; empty if
/// none does. More than one can agree where a case does not tell them apart.
template <class Point>
Misconceptions recognize(const Misconceptions& known,
                         const std::vector<Prediction<Point>>& predictions,
                         const std::vector<Point>& actual, double allowed) {
  Misconceptions recognized;
  if (actual.empty()) return recognized;  // nothing agrees with everything
  for (const Prediction<Point>& prediction : predictions) {
    const Misconception& m = find_misconception(known, prediction.misconception);
    if (!holds(recognized, m.name) && agrees(prediction.points, actual, allowed)) {
      recognized.push_back(m);
    }
  }
  return recognized;
}

}  // namespace meshgrade
