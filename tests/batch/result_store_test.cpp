#include "grader/batch/result_store.h"

#include <gtest/gtest.h>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "tests/support/scratch_files.h"

namespace meshgrade {
namespace {

Result graded(const std::string& key, double points) {
  Result result;
  result.key = key;
  result.fingerprint = "f";
  result.status = ResultStatus::kGraded;
  result.report.emplace().points = points;
  return result;
}

TEST(ResultStore, GivesBackWhatWasSaved) {
  const ScratchFolder folder;
  const ResultStore store(folder.path());
  store.save(graded("Ann/\xC3\x84 \"x\"", 7.25), "text");
  const Result back = store.load("Ann/\xC3\x84 \"x\"");
  EXPECT_EQ(back.status, ResultStatus::kGraded);
  EXPECT_EQ(back.fingerprint, "f");
  EXPECT_EQ(back.report->points, 7.25);
  EXPECT_EQ(store.load("nobody").status, ResultStatus::kMissing);
}

TEST(ResultStore, ALaterResultTakesThePlace) {
  const ScratchFolder folder;
  const ResultStore store(folder.path());
  store.save(graded("ann", 7.0), "text");
  Result ungradable;
  ungradable.key = "ann";
  ungradable.status = ResultStatus::kUngradable;
  ungradable.reason = "nothing there";
  store.save(ungradable, "text");
  const Result back = store.load("ann");
  EXPECT_EQ(back.status, ResultStatus::kUngradable);
  EXPECT_EQ(back.reason, "nothing there");
  EXPECT_FALSE(back.report);
  EXPECT_FALSE(std::filesystem::exists(store.folder_of("ann") / "report.json"));
}

TEST(ResultStore, AnotherPersonsResultIsNotTaken) {
  const ScratchFolder folder;
  const ResultStore store(folder.path());
  store.save(graded("ann", 7.0), "text");
  std::filesystem::copy(store.folder_of("ann"), store.folder_of("bob"));
  EXPECT_EQ(store.load("bob").status, ResultStatus::kMissing);
}

TEST(ResultStore, WhereNothingCanBeWrittenItSaysSo) {
  const ScratchFolder folder;
  const ResultStore store(write_file(folder.path() / "file", "x"));
  EXPECT_THROW(store.save(graded("ann", 7.0), "text"), UserError);
}

}  // namespace
}  // namespace meshgrade
