#include "grader/worker/patience.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

Task task_of(std::uint32_t milliseconds, std::uint64_t steps = 10, std::uint32_t family = 7,
             std::uint32_t calls = 1) {
  Task task;
  task.step_budget = steps;
  task.cpu_ms = task.wall_ms = milliseconds;
  task.family = family;
  task.calls = calls;
  return task;
}

TEST(Patience, IsTheWholeLimitUntilATimeout) {
  EXPECT_EQ(Patience().cpu_limit(task_of(5000)), 5000U);
  EXPECT_EQ(Patience().wall_limit(task_of(5000)), 5000U);
}

TEST(Patience, IsAQuarterAfterATimeoutOfAnyFamily) {
  Patience patience;
  patience.note_timeout(task_of(1, 10, 8, 2));
  EXPECT_EQ(patience.cpu_limit(task_of(5000)), 1250U);
  EXPECT_EQ(patience.cpu_limit(task_of(600)), 250U);
  EXPECT_EQ(patience.cpu_limit(task_of(200)), 200U);
  EXPECT_EQ(patience.wall_limit(task_of(5000)), 1250U);
  EXPECT_EQ(patience.wall_limit(task_of(1000)), 500U);
  EXPECT_EQ(patience.wall_limit(task_of(300)), 300U);
}

TEST(Patience, IsATenthOfTheProcessorWhereTheSameFunctionsWereGivenUp) {
  Patience patience;
  for (std::uint32_t i = 0; i < kMostTimeouts; ++i)
    patience.note_timeout(task_of(1, 10, 8, 1));
  EXPECT_EQ(patience.cpu_limit(task_of(5000)), 500U);
  EXPECT_EQ(patience.cpu_limit(task_of(600)), 100U);
  EXPECT_EQ(patience.wall_limit(task_of(5000)), 1250U);
  EXPECT_EQ(patience.cpu_limit(task_of(5000, 10, 7, 2)), 1250U);
}

TEST(Patience, LeavesLargeCasesTheirTime) {
  Patience patience;
  patience.note_timeout(task_of(1));
  EXPECT_EQ(patience.cpu_limit(task_of(5000, 200'000'000)), 3250U);
  EXPECT_EQ(patience.cpu_limit(task_of(5000, 2'000'000'000)), 5000U);
}

TEST(Patience, OfNoLimitIsNone) {
  Patience patience;
  patience.note_timeout(task_of(1));
  EXPECT_EQ(patience.cpu_limit(task_of(0)), 0U);
  EXPECT_EQ(patience.wall_limit(task_of(0)), 0U);
}

TEST(Patience, IsUsedUpByOneFamilyAtATime) {
  Patience patience;
  for (std::uint32_t i = 0; i < kMostTimeouts; ++i) {
    EXPECT_FALSE(patience.is_used_up(7));
    patience.note_timeout(task_of(1));
  }
  EXPECT_TRUE(patience.is_used_up(7));
  EXPECT_FALSE(patience.is_used_up(8));
}

TEST(Patience, IsLessWithTheNextFamilyOfTheSameFunctions) {
  Patience patience;
  for (std::uint32_t i = 0; i < kMostTimeouts; ++i)
    patience.note_timeout(task_of(1));
  for (std::uint32_t i = 1; i < kMostTimeouts; ++i) {
    EXPECT_FALSE(patience.is_used_up(8));
    patience.note_timeout(task_of(1, 10, 8));
  }
  EXPECT_TRUE(patience.is_used_up(8));
}

TEST(Patience, IsAnEighthOfTheMemoryWhereTheSameFunctionsUsedUpAllOfIt) {
  constexpr std::uint64_t kGigabyte = std::uint64_t{1} << 30U;
  Patience patience;
  patience.note_out_of_memory(task_of(1, 10, 8, 1));
  EXPECT_EQ(patience.memory_limit(task_of(1, 10, 7, 1), 8 * kGigabyte), kGigabyte);
  EXPECT_EQ(patience.memory_limit(task_of(1, 10, 7, 1), kGigabyte), kGigabyte / 4);
  EXPECT_EQ(patience.memory_limit(task_of(1, 10, 7, 1), kGigabyte / 8), kGigabyte / 8);
  EXPECT_EQ(patience.memory_limit(task_of(1, 10, 7, 1), 0), 0U);
  EXPECT_EQ(patience.memory_limit(task_of(1, 10, 7, 2), kGigabyte), kGigabyte);
}

}  // namespace
}  // namespace meshgrade
