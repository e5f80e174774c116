#include "grader/batch/lateness.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

/// Due on March 1 at noon UTC, with ten minutes of grace, 10 % a day, at most 25 points.
std::optional<LateRule> rule() {
  LateRule rule;
  rule.due = *read_moment("2026-03-01 12:00:00Z", 0);
  rule.grace = 600;
  rule.per_day = {0.1, true};
  rule.at_most = PointsOrShare{25.0, false};
  return rule;
}

Lateness at(const std::string& time, bool marked = false) {
  HandIn hand_in;
  hand_in.submitted_at = time;
  hand_in.late = marked;
  return lateness_of(hand_in, rule());
}

TEST(Lateness, BeginsAfterTheMinutesOfGraceAndCountsFromWhenItWasDue) {
  EXPECT_FALSE(at("2026-03-01 12:00:00Z").late);
  EXPECT_EQ(at("2026-03-01 12:00:00Z").note, "");
  EXPECT_FALSE(at("2026-03-01 12:10:00Z").late);
  EXPECT_EQ(at("2026-03-01 12:10:00Z").note,
            "10 min after it was due, within the minutes of grace");
  EXPECT_TRUE(at("2026-03-01 12:10:01Z").late);
  EXPECT_EQ(at("2026-03-01 12:10:01Z").days, 1);
  EXPECT_EQ(at("2026-03-02 12:00:00Z").days, 1);
  EXPECT_EQ(at("2026-03-02 12:00:01Z").days, 2);
  EXPECT_EQ(at("2026-03-03 15:00:00Z").note, "2 days 3 h after it was due");
}

TEST(Lateness, WhoHasNoTimeLosesNothingAndThatIsSaid) {
  EXPECT_EQ(at("").days, 0);
  EXPECT_FALSE(at("").late);
  EXPECT_EQ(at("").note, "no time is known: nothing is taken off");
  EXPECT_TRUE(at("", true).late);
  EXPECT_EQ(at("", true).days, 0);
  EXPECT_EQ(at("", true).note,
            "late by the platform, which tells no time: nothing is taken off");
  EXPECT_EQ(at("last week").days, 0);
  EXPECT_NE(at("last week").note.find("no time that can be read"), std::string::npos);
}

TEST(Lateness, WithoutARuleThePlatformSays) {
  HandIn hand_in;
  hand_in.late = true;
  hand_in.submitted_at = "2030-01-01 00:00Z";
  EXPECT_TRUE(lateness_of(hand_in, std::nullopt).late);
  EXPECT_EQ(lateness_of(hand_in, std::nullopt).days, 0);
}

TEST(Lateness, TakesOffByTheDayAtMostWhatTheRuleSaysAndNeverBelowZero) {
  EXPECT_EQ(late_deduction(*rule(), 0, 90.0, 100.0), 0.0);
  EXPECT_EQ(late_deduction(*rule(), 1, 90.0, 100.0), 10.0);
  EXPECT_EQ(late_deduction(*rule(), 2, 90.0, 100.0), 20.0);
  EXPECT_EQ(late_deduction(*rule(), 3, 90.0, 100.0), 25.0);
  EXPECT_EQ(late_deduction(*rule(), 3, 7.5, 100.0), 7.5);
  EXPECT_EQ(late_deduction(*rule(), 3, 0.0, 100.0), 0.0);
  LateRule endless = *rule();
  endless.at_most.reset();
  EXPECT_EQ(late_deduction(endless, 1'000'000, 90.0, 100.0), 90.0);
}

}  // namespace
}  // namespace meshgrade
