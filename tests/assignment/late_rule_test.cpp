#include "grader/assignment/late_rule.h"

#include <gtest/gtest.h>

#include "grader/assignment/assignment.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

const std::string kDue = "[late]\ndue = 2026-03-01T23:59:00-08:00\n";

TEST(LateRule, IsReadFromTheAssignment) {
  const auto rule = parse_late_rule(
      kDue + "grace_minutes = 15\nper_day = \"10 %\"\nat_most = 30\n", "a.toml");
  ASSERT_TRUE(rule);
  EXPECT_EQ(rule->due, 1'772'438'340);  // 2026-03-02 07:59:00 UTC
  EXPECT_EQ(rule->grace, 900);
  EXPECT_EQ(rule->per_day.of(200.0), 20.0);
  ASSERT_TRUE(rule->at_most);
  EXPECT_EQ(rule->at_most->of(200.0), 30.0);
  EXPECT_FALSE(parse_late_rule("version = 1\n", "a.toml"));
}

TEST(LateRule, EveryMistakeIsToldWithItsLineBeforeAnyWork) {
  const std::pair<std::string, std::string> mistakes[] = {
      {"[late]\nper_day = 1\n", "late.due is missing"},
      {"[late]\ndue = \"tomorrow\"\nper_day = 1\n", "late.due must be a time with its zone"},
      {"[late]\ndue = 2026-03-01T23:59:00\nper_day = 1\n", "late.due must be a time with"},
      {kDue, "late.per_day is missing"},
      {kDue + "per_day = -1\n", "late.per_day must be"},
      {kDue + "per_day = \"200 %\"\n", "late.per_day must be"},
      {kDue + "per_day = \"ten\"\n", "late.per_day must be"},
      {kDue + "per_day = 1\nat_most = true\n", "late.at_most must be"},
      {kDue + "per_day = 1\ngrace_minutes = -5\n", "late.grace_minutes must be"},
      {kDue + "per_day = 1\ngrace = 5\n", "unknown key late.grace"},
      {"late = 3\n", "late must be a table"}};
  for (const auto& [text, words] : mistakes) {
    const std::string message = user_error([&] { parse_assignment(text, "a.toml"); });
    EXPECT_EQ(message.rfind("a.toml:", 0), 0U) << text;
    EXPECT_NE(message.find(words), std::string::npos) << text << message;
  }
}

TEST(LateRule, MomentsOfAllPlatformsAreRead) {
  for (const char* same :
       {"2026-03-02 07:59:00 UTC", "2026-03-02T07:59:00Z", "2026-03-01 23:59:00 -0800",
        "2026-03-01T23:59:00.123456-08:00", "2026-03-02 07:59:00.420533000 Z",
        "2026-03-02 13:29:00 +0530", "2026-03-01 23:59"}) {
    EXPECT_EQ(read_moment(same, -8 * 3600), 1'772'438'340) << same;
  }
  for (const char* none : {"", "yesterday", "2026-13-01 10:00", "2026-02-30 10:00",
                           "2026-03-01", "2026-03-01 25:00", "12026-03-01 10:00"}) {
    EXPECT_FALSE(read_moment(none, 0)) << none;
  }
}

}  // namespace
}  // namespace meshgrade
