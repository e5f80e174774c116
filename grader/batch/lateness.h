#pragma once

#include <optional>
#include <string>

#include "grader/assignment/late_rule.h"
#include "grader/roster/roster.h"

namespace meshgrade {

/// How late a hand-in came, and what an assignment's rule takes off for it.
struct Lateness {
  bool late = false;  ///< by the rule; where it cannot tell, by what the platform says
  int days = 0;       ///< that have begun since it was due; 0 if nothing is to be taken off
  std::string note;   ///< "1 day 2 h 5 min after it was due"; empty if there is nothing to say
};

/// Nothing is taken off where no time is known; then the note says so, if there is a rule.
Lateness lateness_of(const HandIn& hand_in, const std::optional<LateRule>& rule);

/// The points to take off: never more than were earned.
/// @param full_points  what a share is a part of
double late_deduction(const LateRule& rule, int days, double earned, double full_points);

}  // namespace meshgrade
