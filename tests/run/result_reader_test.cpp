#include "grader/run/result_reader.h"

#include <gtest/gtest.h>

#include "grader/base/random.h"

namespace meshgrade {
namespace {

std::string frame(std::uint32_t kind, const std::string& payload) {
  const std::string body = to_wire(kind) + payload;
  return to_wire(static_cast<std::uint64_t>(body.size())) + body;
}

std::string step(std::uint32_t task, const std::string& result) {
  return frame(0, to_wire(StepFrame{task, result}));
}

EndFrame sample_end(std::uint32_t task) {
  EndFrame end;
  end.task = task;
  end.ending = Ending::kFault;
  end.fault_kind = 2;
  end.subject = "vertex handle";
  end.stack = {1, 2, 3};
  end.interrupted = std::string("\0x", 2);
  end.output = "printed";
  end.output_bytes = 4711;
  return end;
}
std::string end(std::uint32_t task) {
  return frame(1, to_wire(sample_end(task)));
}

std::string sample_file() {
  return step(0, "a") + step(0, "bb") + end(0) + end(1) + step(2, "c");
}

TEST(ResultReader, FramesComeBackInOrder) {
  const std::vector<TaskResult> tasks = read_results(sample_file(), 4);
  ASSERT_EQ(tasks.size(), 4U);
  EXPECT_EQ(tasks[0].steps, (std::vector<std::string>{"a", "bb"}));
  EXPECT_TRUE(tasks[0].ended);
  EXPECT_EQ(to_wire(tasks[0].end), to_wire(sample_end(0)));
  EXPECT_TRUE(tasks[1].ended);
  EXPECT_TRUE(tasks[1].steps.empty());
  EXPECT_FALSE(tasks[2].ended);
  EXPECT_EQ(tasks[2].steps.size(), 1U);
  EXPECT_FALSE(tasks[3].ended);
}

TEST(ResultReader, EmptyFileMeansThatNothingHasEnded) {
  for (const TaskResult& task : read_results("", 3))
    EXPECT_FALSE(task.ended);
}

TEST(ResultReader, EveryFileCutInsideAFrameIsRefused) {
  const std::string file = end(0);
  for (std::size_t size = 1; size < file.size(); ++size)
    EXPECT_THROW(read_results(file.substr(0, size), 1), WireError) << size;
}

TEST(ResultReader, TasksOutOfOrderAreRefused) {
  EXPECT_THROW(read_results(end(1), 2), WireError);
  EXPECT_THROW(read_results(end(0) + end(0), 2), WireError);
  EXPECT_THROW(read_results(step(1, "a"), 2), WireError);
  EXPECT_THROW(read_results(end(0) + step(0, "late"), 2), WireError);
}

TEST(ResultReader, MoreTasksThanGivenAreRefused) {
  EXPECT_THROW(read_results(end(0) + end(1), 1), WireError);
  EXPECT_THROW(read_results(step(0, "a"), 0), WireError);
}

TEST(ResultReader, UnknownKindsAreRefused) {
  EXPECT_THROW(read_results(frame(2, to_wire(StepFrame{0, "a"})), 1), WireError);
  EndFrame unknown = sample_end(0);
  unknown.ending = static_cast<Ending>(kLastEnding + 1);
  EXPECT_THROW(read_results(frame(1, to_wire(unknown)), 1), WireError);
}

TEST(ResultReader, FrameLongerThanTheFileIsRefused) {
  EXPECT_THROW(read_results(to_wire(~std::uint64_t{0}) + "abc", 1), WireError);
  EXPECT_THROW(read_results(to_wire(std::uint64_t{100}) + "abc", 1), WireError);
}

TEST(ResultReader, BytesAtTheEndOfAFrameAreRefused) {
  EXPECT_THROW(read_results(frame(1, to_wire(sample_end(0)) + "x"), 1), WireError);
}

TEST(ResultReader, MoreThanTheWorkerKeepsIsRefused) {
  EndFrame deep = sample_end(0);
  deep.stack.resize(kMostStackFrames + 1);
  EXPECT_THROW(read_results(frame(1, to_wire(deep)), 1), WireError);
  EndFrame loud = sample_end(0);
  loud.output.resize(kKeptOutputBytes + 1);
  EXPECT_THROW(read_results(frame(1, to_wire(loud)), 1), WireError);
}

TEST(ResultReader, AnyBytesAreReadOrRefused) {
  Random random(1, "results");
  const std::string right = sample_file();
  int refused = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::string bytes = right;
    for (std::uint32_t i = 1 + random.below(3); i > 0; --i)
      bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] =
          static_cast<char>(random.below(256));
    if (random.below(3) == 0)
      bytes.resize(random.below(static_cast<std::uint32_t>(right.size())));
    try {
      std::size_t kept = 0;
      for (const TaskResult& task : read_results(bytes, 4)) {
        kept += task.end.subject.size() + task.end.output.size();
        for (const std::string& s : task.steps)
          kept += s.size();
      }
      EXPECT_LE(kept, bytes.size());
    } catch (const WireError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 5000);
}

}  // namespace
}  // namespace meshgrade
