#include "grader/base/pattern.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

TEST(Pattern, MatchesWholeTextsAndTellsGroups) {
  const Pattern pattern("(a+)(b)?(c)");
  Pattern::Groups groups{"as before"};
  EXPECT_FALSE(pattern.matches("xaac"));
  EXPECT_FALSE(pattern.matches("xaac", groups));
  EXPECT_EQ(groups, (Pattern::Groups{"as before"}));
  EXPECT_TRUE(pattern.matches("aac", groups));
  EXPECT_EQ(groups, (Pattern::Groups{"aac", "aa", "", "c"}));
}

TEST(Pattern, FindsTheFirstPart) {
  const Pattern pattern("(\\d)\\.");
  Pattern::Groups groups;
  EXPECT_TRUE(pattern.is_in("1 2. 3."));
  EXPECT_TRUE(pattern.is_in("1 2. 3.", groups));
  EXPECT_EQ(groups, (Pattern::Groups{"2.", "2"}));
  EXPECT_FALSE(pattern.is_in("none", groups));
}

TEST(Pattern, FindsAllParts) {
  const auto places = Pattern("ab?").places_in("a-ab-b");
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].begin, 0U);
  EXPECT_EQ(places[0].size, 1U);
  EXPECT_EQ(places[1].begin, 2U);
  EXPECT_EQ(places[1].size, 2U);
}

TEST(Pattern, ReplacesAllParts) {
  EXPECT_EQ(Pattern("(a)b").replaced("ab abc", "<$1>"), "<a> <a>c");
}

TEST(Pattern, OutlivesWhatItWasMadeOf) {
  const Pattern copy = [] { return Pattern(std::string("x") + "y"); }();
  EXPECT_TRUE(copy.matches("xy"));
}

}  // namespace
}  // namespace meshgrade
