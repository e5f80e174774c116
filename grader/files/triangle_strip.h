#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace meshgrade {

/// Ends a strip in a list of strips.
constexpr std::uint32_t kStripEnd = std::numeric_limits<std::uint32_t>::max();

/// Cuts strips of vertices into triangles that keep the winding of the first: every other one
/// is turned. Strips are stitched together by triangles that name a vertex twice; those go.
std::vector<std::vector<std::uint32_t>> cut_strips(const std::vector<std::uint32_t>& strips);

/// Cuts a fan, whose triangles share its first vertex, into triangles. Those that name a vertex
/// twice go.
std::vector<std::vector<std::uint32_t>> cut_fan(const std::vector<std::uint32_t>& fan);

}  // namespace meshgrade
