#include "grader/base/wire.h"

#include <gtest/gtest.h>

#include "grader/base/protocol.h"
#include "grader/base/random.h"

namespace meshgrade {
namespace {

TaskList sample_tasks() {
  TaskList list;
  list.memory_bytes = 1U << 30U;
  list.result_bytes = 77;
  list.alone = true;
  list.tasks = {{"edge_flip", std::string("\0\xFF x", 4), 12, 34, 56}, {"", "", 0, 0, 0}};
  return list;
}

TEST(Wire, WhatIsPackedComesBack) {
  const TaskList list = from_wire<TaskList>(to_wire(sample_tasks()));
  EXPECT_EQ(list.version, kProtocolVersion);
  EXPECT_EQ(list.result_bytes, 77U);
  EXPECT_TRUE(list.alone);
  ASSERT_EQ(list.tasks.size(), 2U);
  EXPECT_EQ(list.tasks[0].exercise, "edge_flip");
  EXPECT_EQ(list.tasks[0].input, std::string("\0\xFF x", 4));
  EXPECT_EQ(list.tasks[0].wall_ms, 56U);
  EXPECT_EQ(to_wire(list), to_wire(sample_tasks()));
}

TEST(Wire, NestedListsComeBack) {
  const std::vector<std::vector<std::array<double, 3>>> net{{{1, 2, 3}}, {}, {{4, 5, 6}, {}}};
  EXPECT_EQ((from_wire<std::vector<std::vector<std::array<double, 3>>>>(to_wire(net))), net);
}

TEST(Wire, EveryShorterTextIsRefused) {
  const std::string bytes = to_wire(sample_tasks());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(from_wire<TaskList>(std::string_view(bytes).substr(0, size)), WireError)
        << size;
  }
}

TEST(Wire, BytesAtTheEndAreRefused) {
  EXPECT_THROW(from_wire<TaskList>(to_wire(sample_tasks()) + "x"), WireError);
}

TEST(Wire, ListLongerThanTheBytesIsRefusedBeforeItIsMade) {
  const std::string huge = to_wire(std::uint64_t{1} << 60U) + "abc";
  EXPECT_THROW(from_wire<std::string>(huge), WireError);
  EXPECT_THROW(from_wire<std::vector<double>>(huge), WireError);
  EXPECT_THROW(from_wire<std::vector<std::string>>(huge), WireError);
  // So large that the size in bytes wraps around to a small number.
  const std::string wrapping = to_wire((std::uint64_t{1} << 61U) + 1) + std::string(8, 'x');
  EXPECT_THROW(from_wire<std::vector<double>>(wrapping), WireError);
}

TEST(Wire, FlagThatIsNeitherTrueNorFalseIsRefused) {
  EXPECT_TRUE(from_wire<bool>(std::string("\1", 1)));
  EXPECT_THROW(from_wire<bool>("\2"), WireError);
}

TEST(Wire, RandomBytesAreReadOrRefused) {
  Random random(5, "wire");
  const std::string right = to_wire(sample_tasks());
  for (int round = 0; round < 5000; ++round) {
    std::string bytes = right;
    for (std::uint32_t i = 1 + random.below(4); i > 0; --i)
      bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] =
          static_cast<char>(random.below(256));
    try {
      EXPECT_EQ(to_wire(from_wire<TaskList>(bytes)), bytes);
    } catch (const WireError&) {
    }
  }
}

}  // namespace
}  // namespace meshgrade
