#pragma once

// What a wrong answer probably comes from. Every known misconception predicts the numbers that
// it would give; it is named only when the student's numbers are these.

#include <string>
#include <vector>

#include "grader/judge/point_compare.h"

namespace meshgrade {

struct Misconception {
  std::string name;    ///< short, as in the tests: "t-swapped"
  std::string advice;  ///< a sentence for the student
};

/// The points that a misconception gives in place of the expected ones.
template <class Point>
struct Prediction {
  Misconception misconception;
  std::vector<Point> points;
};

/// The advice of the predictions that agree with `actual` everywhere, to `allowed` (a length);
/// empty if none does. More than one can agree where a case does not tell them apart.
template <class Point>
std::vector<Misconception> recognize(const std::vector<Prediction<Point>>& predictions,
                                     const std::vector<Point>& actual, double allowed) {
  std::vector<Misconception> recognized;
  if (actual.empty()) return recognized;  // nothing agrees with everything
  for (const Prediction<Point>& prediction : predictions) {
    if (prediction.points.size() != actual.size()) continue;
    if (worst_point(prediction.points, actual).error > allowed) continue;
    recognized.push_back(prediction.misconception);
  }
  return recognized;
}

}  // namespace meshgrade
