#include "grader/worker/patience.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

Task task_of(std::uint64_t steps) {
  Task task;
  task.step_budget = steps;
  return task;
}

TEST(Patience, IsTheWholeLimitUntilATimeout) {
  EXPECT_EQ(Patience().limit(task_of(10), 5000), 5000U);
}

TEST(Patience, IsAQuarterAfterATimeoutOfAnyFamily) {
  Patience patience;
  patience.note_timeout(7);
  EXPECT_EQ(patience.limit(task_of(10), 5000), 1250U);
  EXPECT_EQ(patience.limit(task_of(10), 1000), 500U);
  EXPECT_EQ(patience.limit(task_of(10), 300), 300U);
}

TEST(Patience, LeavesLargeCasesTheirTime) {
  Patience patience;
  patience.note_timeout(7);
  EXPECT_EQ(patience.limit(task_of(20'000'000), 5000), 3250U);
  EXPECT_EQ(patience.limit(task_of(200'000'000), 5000), 5000U);
}

TEST(Patience, OfNoLimitIsNone) {
  Patience patience;
  patience.note_timeout(7);
  EXPECT_EQ(patience.limit(task_of(10), 0), 0U);
}

TEST(Patience, IsUsedUpByOneFamilyAtATime) {
  Patience patience;
  for (std::uint32_t i = 0; i < kMostTimeouts; ++i) {
    EXPECT_FALSE(patience.is_used_up(7));
    patience.note_timeout(7);
  }
  EXPECT_TRUE(patience.is_used_up(7));
  EXPECT_FALSE(patience.is_used_up(8));
}

}  // namespace
}  // namespace meshgrade
