#include "grader/base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

namespace meshgrade {
namespace {

std::vector<double> first_units(std::uint64_t seed, const std::string& stream) {
  Random random(seed, stream);
  std::vector<double> values;
  for (int i = 0; i < 100; ++i)
    values.push_back(random.unit());
  return values;
}

TEST(Random, TheSameSeedAndStreamGiveTheSameNumbers) {
  EXPECT_EQ(first_units(184, "edge_flip/sequences"), first_units(184, "edge_flip/sequences"));
}

TEST(Random, AnotherSeedOrStreamGivesOtherNumbers) {
  std::set<std::vector<double>> streams;
  for (const char* name : {"", "a", "b", "ab", "ba"})
    streams.insert(first_units(184, name));
  EXPECT_EQ(streams.size(), 5U);
  for (std::uint64_t seed : {0U, 1U, 2U, 185U})
    streams.insert(first_units(seed, "ab"));
  EXPECT_EQ(streams.size(), 9U);
}

TEST(Random, StreamIsTheStandardEngineSeededByFnv1a) {
  // The definition: 64-bit FNV-1a of the eight bytes of the seed, lowest first, and the name.
  std::uint64_t hash = 14695981039346656037ULL;
  for (unsigned char byte : std::string({7, 0, 0, 0, 0, 0, 0, 0, 'x'}))
    hash = (hash ^ byte) * 1099511628211ULL;
  std::mt19937_64 engine(hash);
  Random random(7, "x");
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(random.below(1000), engine() % 1000);
}

TEST(Random, SeedAndNameDoNotMix) {
  Random one(1, "a");
  Random other(2, "b");  // 1 ^ 'a' is 2 ^ 'b'
  EXPECT_NE(one.unit(), other.unit());
}

TEST(Random, UnitsFitIntoAFloatAndAreSpreadEvenly) {
  Random random(3, "units");
  std::array<int, 10> buckets{};
  for (int i = 0; i < 10'000; ++i) {
    const double x = random.unit();
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
    ASSERT_EQ(static_cast<double>(static_cast<float>(x)), x);
    ++buckets[static_cast<std::size_t>(10.0 * x)];
  }
  for (int count : buckets)
    EXPECT_NEAR(count, 1000, 150);
}

TEST(Random, ValuesStayWithinTheirLimits) {
  Random random(4, "limits");
  std::set<std::uint32_t> seen;
  for (int i = 0; i < 1000; ++i) {
    seen.insert(random.below(7));
    const double x = random.between(-3.0, 5.0);
    ASSERT_GE(x, -3.0);
    ASSERT_LT(x, 5.0);
  }
  EXPECT_EQ(seen, (std::set<std::uint32_t>{0, 1, 2, 3, 4, 5, 6}));
}

}  // namespace
}  // namespace meshgrade
