#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace meshgrade {

/// A part of the full points, or a number of points.
struct PointsOrShare {
  double value = 0.0;  ///< points; or a share of the full points from 0 to 1
  bool is_share = false;

  double of(double full_points) const { return is_share ? value * full_points : value; }
};

/// What late work costs: `[late]` of the assignment (docs/assignment.md). Grading does not
/// depend on it: it is taken off what was earned, when the results of a class are put together.
struct LateRule {
  std::int64_t due = 0;                  ///< seconds since 1970, in UTC
  std::int64_t zone = 0;                 ///< seconds east of UTC, of times that name no zone
  std::int64_t grace = 0;                ///< seconds after it that cost nothing
  PointsOrShare per_day;                 ///< for each day that has begun since it was due
  std::optional<PointsOrShare> at_most;  ///< taken off in all; else everything
};

/// The rule of an assignment file; empty if it has none.
/// @throws UserError that names the file, the line and the key
std::optional<LateRule> read_late_rule(const std::filesystem::path& file);

/// The same from the text of an assignment. `name` stands for the file in messages.
std::optional<LateRule> parse_late_rule(const std::string& text, const std::string& name);

/// A moment as platforms write it, in seconds since 1970: "2026-03-01 23:59:00.5 -0800",
/// "2026-03-01T23:59:00Z". Without a zone it is `zone` seconds east of UTC. Empty for what is
/// no such moment.
std::optional<std::int64_t> read_moment(const std::string& text, std::int64_t zone);

}  // namespace meshgrade
