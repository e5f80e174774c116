#pragma once

// How distances from OpenSubdiv's answer are told and coloured, on the page and in SVG alike.

#include <array>
#include <string>
#include <vector>

#include "grader/judge/deviation.h"

namespace meshgrade {

/// From "just so" to the largest distance. Each is darker than the one before, so that the
/// order can be seen without seeing colours.
constexpr std::array<const char*, 5> kDeviationColors{"#fdf3cf", "#b5d5b2", "#62a6b8",
                                                      "#3a66a7", "#35206b"};

/// What the last colour stands for: the largest distance, or what is allowed if that is more,
/// so that rounding errors do not look like mistakes.
double deviation_range(const Deviation& deviation);

/// "#62a6b8", for a distance; the last colour if it is not finite.
std::string deviation_color(const Deviation& deviation, double distance);

/// The vertices to mark: of those that are off by more than is allowed, the worst few.
std::vector<Ref> shown_worst(const Deviation& deviation);

/// "v3 is off by 0.012 of the mesh's diagonal"
std::string deviation_text(const Deviation& deviation, Ref vertex);

/// The whole in a sentence or two.
std::string deviation_text(const Deviation& deviation);

/// What stands at the two ends of the legend.
std::array<std::string, 2> deviation_ends(const Deviation& deviation);

}  // namespace meshgrade
