// `--jobs-file`: commands for any scheduler.

#include <gmock/gmock.h>

#include "grader/base/text.h"
#include "tests/cluster/small_class.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

class JobsFile : public SmallClass {
 protected:
  std::filesystem::path file_ = scratch_.path() / "jobs.txt";

  std::vector<std::string> write_lines() {
    const ProcessResult said =
        run(batch_command({"--jobs-file", file_.string(), "--per-task", "2"}));
    EXPECT_EQ(said.status, 0) << said.output;
    EXPECT_THAT(said.output, HasSubstr("without --jobs-file collects the results"));
    return split_lines(read_whole_file(file_));
  }

  /// As a scheduler does it; a task that grades an empty hand-in ends with 1.
  static void run_line(const std::string& line) {
    EXPECT_LE(run({"sh", "-c", line}).status, 1) << line;
  }
};

TEST_F(JobsFile, IsDoneElsewhereAndCollectedByTheSameCommand) {
  hand_in(5);
  const std::vector<std::string> lines = write_lines();
  ASSERT_THAT(lines, SizeIs(3));
  for (const std::string& line : lines)
    run_line(line);
  const ProcessResult said = run(batch_command({}));
  EXPECT_THAT(said.output, HasSubstr("5 of 6 hand-ins graded, 1 ungradable"));
  EXPECT_THAT(said.output, HasSubstr("(unchanged)")) << "nothing is graded twice";
  EXPECT_FALSE(std::filesystem::exists(results_ / ".tasks"));
  const std::string elsewhere = grades();
  EXPECT_EQ(elsewhere, grades_without_cluster());
}

TEST_F(JobsFile, WhatNoTaskHasDoneIsDoneByTheCommandThatCollects) {
  hand_in(4);
  const std::vector<std::string> lines = write_lines();
  run_line(lines.at(0));
  run_line(lines.at(0));  // doubled, which does no harm
  EXPECT_THAT(run(batch_command({})).output, HasSubstr("4 of 5 hand-ins graded"));
}

TEST_F(JobsFile, ResultsOfOtherFilesAreNotTaken) {
  hand_in(1);
  for (const std::string& line : write_lines())
    run_line(line);
  write_file_safely(class_ / "student100" / "bezier_curve.cpp", "int empty;\n");
  EXPECT_THAT(run(batch_command({})).output, HasSubstr("student100: 0 of 10 points"));
}

TEST_F(JobsFile, NeedsAFolder) {
  class_ = scratch_.path() / "class.zip";
  write_file_safely(class_, "PK");
  const ProcessResult said = run(batch_command({"--jobs-file", file_.string()}));
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("unpack it first"));
}

}  // namespace
}  // namespace meshgrade
