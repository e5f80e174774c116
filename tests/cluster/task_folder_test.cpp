#include "grader/cluster/task_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grader/base/process.h"
#include "grader/base/safe_file.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

Result result(const std::string& key, const std::string& fingerprint, double points) {
  Result made;
  made.key = key;
  made.fingerprint = fingerprint;
  made.status = ResultStatus::kGraded;
  made.report.emplace().points = points;
  return made;
}

class Tasks : public testing::Test {
 protected:
  /// What a task left behind.
  void finish(const std::string& run, const Result& made) const {
    result_store(tasks_.result_stem("r0").string() + run).save(made, "a page\n");
  }

  ScratchFolder scratch_;
  TaskFolder tasks_{scratch_.path()};
  ResultStore store_ = result_store(scratch_.path());
};

TEST_F(Tasks, ListsHoldEveryHandInOnce) {
  ASSERT_EQ(tasks_.write_lists("r0", {"a", "b b", "c", "d", "e"}, 2), 3U);
  const std::string stem = tasks_.list_stem("r0").string();
  EXPECT_THAT(read_task_list(stem + "0.txt"), ElementsAre("a", "b b"));
  EXPECT_THAT(read_task_list(stem + "1.txt"), ElementsAre("c", "d"));
  EXPECT_THAT(read_task_list(stem + "2.txt"), ElementsAre("e"));
}

TEST_F(Tasks, FinishedResultsAreTakenOverOnce) {
  tasks_.write_lists("r0", {"a", "b"}, 1);
  finish("0-7-0", result("a", "one", 3.0));
  finish("0-7-1", result("a", "one", 3.0));  // a doubled task
  EXPECT_THAT(tasks_.collect({{"a", "one"}, {"b", "two"}}, store_), ElementsAre("a"));
  EXPECT_EQ(store_.load("a").report->points, 3.0);
  EXPECT_EQ(store_.load("b").status, ResultStatus::kMissing);
}

TEST_F(Tasks, ResultsOfAnotherVersionOrOfNobodyAreLeft) {
  tasks_.write_lists("r0", {"a"}, 1);
  finish("0-7-0", result("a", "old", 3.0));
  finish("1-7-0", result("zoe", "one", 3.0));
  EXPECT_THAT(tasks_.collect({{"a", "new"}}, store_), IsEmpty());
}

TEST_F(Tasks, DamagedAndHalfWrittenResultsAreLeft) {
  tasks_.write_lists("r0", {"a", "b"}, 1);
  finish("0-7-0", result("a", "one", 3.0));
  finish("0-7-0", result("b", "two", 3.0));
  const ResultStore task = result_store(tasks_.result_stem("r0").string() + "0-7-0");
  write_file_safely(task.folder_of("a") / "report.json", "{}");
  fs::remove(task.folder_of("b") / "result.json");
  EXPECT_THAT(tasks_.collect({{"a", "one"}, {"b", "two"}}, store_), IsEmpty());
}

TEST_F(Tasks, AJobIsRememberedUntilTheFolderGoes) {
  EXPECT_EQ(tasks_.job(), "");
  tasks_.write_lists("r0", {"a"}, 1);
  tasks_.remember_job("4711");
  EXPECT_EQ(TaskFolder(scratch_.path()).job(), "4711");
  tasks_.remove();
  EXPECT_EQ(tasks_.job(), "");
}

}  // namespace
}  // namespace meshgrade
