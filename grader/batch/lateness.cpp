#include "grader/batch/lateness.h"

#include <algorithm>
#include <cmath>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

constexpr std::int64_t kDay = 86'400;

/// "2 days 3 h", "5 h 7 min", "20 min", "45 s"
std::string duration_text(std::int64_t seconds) {
  const std::int64_t days = seconds / kDay;
  const std::int64_t hours = seconds / 3600 % 24;
  const std::int64_t minutes = seconds / 60 % 60;
  if (days > 0) {
    return plural(static_cast<std::size_t>(days), "day") +
           (hours > 0 ? " " + std::to_string(hours) + " h" : "");
  }
  if (hours > 0) {
    return std::to_string(hours) + " h" +
           (minutes > 0 ? " " + std::to_string(minutes) + " min" : "");
  }
  if (minutes > 0) return std::to_string(minutes) + " min";
  return std::to_string(seconds) + " s";
}

Lateness without_time(const HandIn& hand_in) {
  if (!hand_in.submitted_at.empty()) {
    return {hand_in.late, 0,
            "handed in at \"" + printable(hand_in.submitted_at) +
                "\", which is no time that can be read: nothing is taken off"};
  }
  return {hand_in.late, 0,
          hand_in.late ? "late by the platform, which tells no time: nothing is taken off"
                       : "no time is known: nothing is taken off"};
}

}  // namespace

Lateness lateness_of(const HandIn& hand_in, const std::optional<LateRule>& rule) {
  if (!rule) return {hand_in.late, 0, ""};
  const auto moment = read_moment(hand_in.submitted_at, rule->zone);
  if (!moment) return without_time(hand_in);
  const std::int64_t after = *moment - rule->due;
  if (after <= 0) return {};
  const std::string when = duration_text(after) + " after it was due";
  if (after <= rule->grace) return {false, 0, when + ", within the minutes of grace"};
  return {true, static_cast<int>(std::min<std::int64_t>((after + kDay - 1) / kDay, 1'000'000)),
          when};
}

double late_deduction(const LateRule& rule, int days, double earned, double full_points) {
  double deduction = days * rule.per_day.of(full_points);
  if (rule.at_most) deduction = std::min(deduction, rule.at_most->of(full_points));
  deduction = std::round(deduction * 100.0) / 100.0;
  return std::clamp(deduction, 0.0, std::max(0.0, earned));
}

}  // namespace meshgrade
