#include "grader/view/deviation_scale.h"

#include <algorithm>
#include <cmath>

#include "grader/base/text.h"
#include "grader/report/svg_pen.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostMarked = 8;

}  // namespace

double deviation_range(const Deviation& deviation) {
  return std::isfinite(deviation.largest) ? std::max(deviation.largest, deviation.allowed)
                                          : 1.0;
}

std::string deviation_color(const Deviation& deviation, double distance) {
  const double last = kDeviationColors.size() - 1.0;
  const double part = std::isfinite(distance) ? distance / deviation_range(deviation) : 1.0;
  const double place = last * std::clamp(part, 0.0, 1.0);
  const auto below = static_cast<std::size_t>(std::min(place, last - 1.0));
  return mixed_color(kDeviationColors[below], kDeviationColors[below + 1],
                     place - static_cast<double>(below));
}

std::vector<Ref> shown_worst(const Deviation& deviation) {
  const auto count = static_cast<long>(std::min(deviation.worst.size(), kMostMarked));
  return {deviation.worst.begin(), deviation.worst.begin() + count};
}

std::string deviation_text(const Deviation& deviation, Ref vertex) {
  return vertex_name(vertex) + " is off by " + number_text(deviation.of_vertex[vertex], 3) +
         " of the mesh's diagonal";
}

std::string deviation_text(const Deviation& deviation) {
  const std::string compared = "compared with OpenSubdiv by " + deviation.weights;
  if (deviation.worst.empty()) {
    return "Every vertex is where it must be, " + compared + ": the largest distance is " +
           number_text(deviation.largest, 3) + " of the mesh's diagonal.";
  }
  const auto all = std::count_if(deviation.of_vertex.begin(), deviation.of_vertex.end(),
                                 [](double off) { return !std::isnan(off); });
  return "Off: " + std::to_string(deviation.worst.size()) + " of " + std::to_string(all) +
         " vertices, " + compared + "; " + deviation_text(deviation, deviation.worst[0]) +
         ", the most.";
}

std::array<std::string, 2> deviation_ends(const Deviation& deviation) {
  return {"0", number_text(deviation_range(deviation), 3) + " of the diagonal"};
}

}  // namespace meshgrade
