// Nothing is lost: a batch may be killed at any moment, and goes on where it was.

#include "grader/batch/batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "tests/batch/made_up_class.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

BatchOptions with_jobs(unsigned jobs) {
  BatchOptions options;
  options.jobs = jobs;
  return options;
}

TEST(Batch, EveryoneGetsTheirPointsAtAnyNumberOfJobs) {
  for (const unsigned jobs : {1U, 2U, 7U}) {
    MadeUpClass made({{"ann", "10"}, {"bob", "0"}, {"cem", "7.5"}});
    EXPECT_TRUE(made.run(with_jobs(jobs)));
    EXPECT_EQ(made.result_of("ann").report->points, 10.0);
    EXPECT_EQ(made.result_of("bob").report->points, 0.0);
    EXPECT_EQ(made.result_of("cem").report->points, 7.5);
  }
}

TEST(Batch, ADisasterIsOnlyItsOwn) {
  MadeUpClass made(
      {{"ann", "10"}, {"bob", "die"}, {"cem", "throw"}, {"dan", "error"}, {"eve", "4"}});
  write_file(made.submissions() / "fay" / "essay.txt", "no code");
  EXPECT_TRUE(made.run());
  EXPECT_EQ(made.result_of("ann").report->points, 10.0);
  EXPECT_EQ(made.result_of("eve").report->points, 4.0);
  EXPECT_EQ(made.result_of("bob").status, ResultStatus::kGraderError);
  EXPECT_THAT(made.result_of("bob").reason, HasSubstr("its process died: Killed"));
  EXPECT_EQ(made.result_of("cem").status, ResultStatus::kGraderError);
  EXPECT_EQ(made.result_of("cem").reason, "out of ideas");
  EXPECT_EQ(made.result_of("dan").status, ResultStatus::kGraderError);
  EXPECT_FALSE(made.result_of("dan").report);
  EXPECT_EQ(made.result_of("fay").status, ResultStatus::kUngradable);
  EXPECT_THAT(made.result_of("fay").reason, HasSubstr("no C++ source file"));
}

TEST(Batch, WhatHasNotChangedIsNotGradedAgain) {
  MadeUpClass made({{"ann", "10"}, {"bob", "2"}, {"cem", "throw"}});
  made.run();
  EXPECT_THAT(made.graded(), ElementsAre("ann", "bob", "cem", "cem"));
  made.run();
  EXPECT_THAT(made.graded(), ElementsAre("cem", "cem"))
      << "a fault of the grader is tried again";
  EXPECT_TRUE(made.steps["ann"].kept);
  EXPECT_EQ(made.steps["bob"].points, 2.0);
  made.hand_in("bob", "9");
  made.run();
  EXPECT_THAT(made.graded(), ElementsAre("bob", "cem", "cem"));
  EXPECT_EQ(made.result_of("bob").report->points, 9.0);
  made.grading.identity = "grader 2";
  made.run();
  EXPECT_THAT(made.graded(), ElementsAre("ann", "bob", "cem", "cem"));
}

TEST(Batch, AnErrorOfTheGraderIsTriedOnceMoreAndSaid) {
  for (const char* once : {"throw once", "die once", "error once"}) {
    SCOPED_TRACE(once);
    MadeUpClass made({{"ann", "10"}, {"bob", once}});
    EXPECT_TRUE(made.run());
    EXPECT_THAT(made.graded(), ElementsAre("ann", "bob", "bob"));
    EXPECT_EQ(made.result_of("bob").status, ResultStatus::kGraded);
    EXPECT_EQ(made.result_of("bob").report->points, 1.0);
    EXPECT_TRUE(made.steps["bob"].again);
    EXPECT_FALSE(made.steps["bob"].reason.empty());
    EXPECT_FALSE(made.steps["ann"].again);
  }
}

TEST(Batch, AFolderOfGraderErrorsIsResumedByTheSameCommand) {
  MadeUpClass::Texts texts;
  for (int i = 0; i < 16; ++i)
    texts["student" + std::to_string(i)] = i % 2 == 0 ? "die" : "throw";
  MadeUpClass made(texts);
  made.run(with_jobs(3));
  for (const auto& [who, text] : texts)
    EXPECT_EQ(made.result_of(who).status, ResultStatus::kGraderError) << who;
  const Grading real = made.grading;
  made.grading.grade = [&](const Submission& submission, unsigned slot) {
    Submission mended = submission;
    mended.sources.at(0).text = "5";
    return real.grade(mended, slot);
  };
  made.run(with_jobs(3));
  for (const auto& [who, text] : texts) {
    EXPECT_EQ(made.result_of(who).status, ResultStatus::kGraded) << who;
    EXPECT_EQ(made.result_of(who).report->points, 5.0) << who;
  }
}

TEST(Batch, ForceAndOnlyChooseWhoIsGraded) {
  MadeUpClass made({{"ann", "10"}, {"bob", "2"}, {"cem", "3"}});
  BatchOptions options;
  made.run(options, {"bob"});
  EXPECT_THAT(made.graded(), ElementsAre("bob"));
  made.run(options, {"bob"});
  EXPECT_THAT(made.graded(), IsEmpty());
  options.force = true;
  made.run(options, {"cem", "bob"});
  EXPECT_THAT(made.graded(), ElementsAre("bob", "cem"));
  EXPECT_EQ(user_error([&] {
              made.run(options, {"bob", "zoe"});
            }),
            "there is no hand-in of \"zoe\"; --list shows whose there are");
}

TEST(Batch, ADamagedResultIsNoticedAndRedone) {
  for (const char* file : {"report.json", "report.txt", "result.json"}) {
    for (const char* text : {"", "{}", "\x80 garbage"}) {
      MadeUpClass made({{"ann", "10"}, {"bob", "2"}});
      made.run();
      write_file(made.store().folder_of("bob") / file, text);
      made.run();
      EXPECT_THAT(made.graded(), ElementsAre("bob")) << file;
      EXPECT_EQ(made.steps["bob"].reason, "its result is damaged");
      EXPECT_EQ(made.result_of("bob").report->points, 2.0);
    }
  }
}

TEST(Batch, FilesOfTheirOwnLieBesideTheReport) {
  MadeUpClass made(MadeUpClass::Texts{{"ann", "10"}});
  made.grading.add_files = [](Report& report, const fs::path& folder) {
    write_file(folder / "picture.svg", "<svg/>");
    report.notes.emplace_back("see picture.svg");
  };
  made.run();
  EXPECT_TRUE(fs::exists(made.store().folder_of("ann") / "picture.svg"));
  EXPECT_THAT(made.result_of("ann").report->notes, ElementsAre("see picture.svg"));
}

TEST(Batch, AStoppedBatchGoesOn) {
  MadeUpClass made({{"ann", "10"}, {"bob", "2"}, {"cem", "3"}});
  BatchOptions options;
  options.stop = [&] { return !made.steps.empty(); };
  EXPECT_FALSE(made.run(options));
  EXPECT_TRUE(made.run());
  for (const char* who : {"ann", "bob", "cem"})
    EXPECT_TRUE(made.result_of(who).report) << who;
}

/// Runs the batch in a process of its own that is killed after `delay`.
void run_and_kill(MadeUpClass& made, std::chrono::microseconds delay) {
  const pid_t process = ::fork();
  if (process == 0) {
    const std::string error = user_error([&] { made.run(with_jobs(2)); });
    if (!error.empty()) std::cerr << error << "\n";
    ::_exit(error.empty() ? 0 : 1);
  }
  ::usleep(static_cast<useconds_t>(delay.count()));
  ::kill(process, SIGKILL);
  int status = 0;
  ::waitpid(process, &status, 0);
  EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) != 0) << "it must be able to go on";
}

TEST(Batch, KilledAtTwentyMomentsItLosesNothingAndRepeatsLittle) {
  std::map<std::string, std::string> texts;
  for (int i = 0; i < 60; ++i)
    texts["student" + std::to_string(i)] = i % 2 == 0 ? "slow" : "5";
  MadeUpClass made(texts);
  std::mt19937 random(7);
  std::set<std::string> whole;
  for (int i = 0; i < 20; ++i) {
    run_and_kill(made, std::chrono::microseconds(random() % 60'000));
    for (const auto& [who, text] : texts) {
      const Result result = made.result_of(who);
      EXPECT_TRUE(result.report || whole.count(who) == 0) << who << " was lost";
      if (!result.report) continue;
      EXPECT_EQ(result.report->points, text == "slow" ? 3.0 : 5.0);
      whole.insert(who);
    }
  }
  EXPECT_TRUE(made.run(with_jobs(2)));
  EXPECT_EQ(made.graded().size(), texts.size() - whole.size());
  for (const auto& [who, text] : texts)
    EXPECT_TRUE(made.result_of(who).report) << who;
  EXPECT_FALSE(fs::exists(made.results() / ".tmp"));
}

TEST(Batch, AFullDiskStopsItAndTakesNobodysPoints) {
  MadeUpClass made({{"ann", "10"}, {"bob", "2"}});
  const pid_t process = ::fork();
  if (process == 0) {
    // Files may not grow beyond a few bytes: to the program, a disk that is full.
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100, 100};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::_exit(user_error([&] { made.run(); }).find("cannot be written") != std::string::npos ? 0
                                                                                           : 1);
  }
  int status = 0;
  ::waitpid(process, &status, 0);
  EXPECT_EQ(status, 0) << "it must say that the results cannot be written";
  EXPECT_EQ(made.result_of("ann").status, ResultStatus::kMissing);
  EXPECT_TRUE(made.run());
  EXPECT_EQ(made.result_of("ann").report->points, 10.0);
}

TEST(Batch, TwoBatchesDoNotWriteToTheSameFolder) {
  MadeUpClass made(MadeUpClass::Texts{{"ann", "10"}});
  {
    const BatchFolder first(made.results());
    EXPECT_THAT(user_error([&] { made.run(); }),
                HasSubstr("another batch is writing its results here"));
  }
  EXPECT_TRUE(made.run());
}

TEST(Batch, NothingIsWrittenOutsideTheResults) {
  MadeUpClass made({{"ann", "10"}, {"C:con", "3"}});
  made.run();
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(made.scratch.path()))
    names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::UnorderedElementsAre("submissions", "results", "log"));
}

TEST(ClassResults, AreReadBackFromTheirJson) {
  MadeUpClass made({{"ann", "10"}, {"bob", "throw"}});
  write_file(made.submissions() / "note.txt", "x");
  made.run();
  const ClassResults results =
      collect_results(read_roster(made.submissions(), {}), one_exercise(), {}, made.store());
  ASSERT_EQ(results.rows.size(), 2U);
  EXPECT_EQ(results.rows[0].points, 10.0);
  EXPECT_EQ(results.rows[0].exercises.at(0).verdict, "passed");
  EXPECT_FALSE(results.rows[1].has_points());
  EXPECT_EQ(results.left_out.at(0).what, "note.txt");
  const std::string json = to_json(results);
  EXPECT_EQ(to_json(read_class_results(json)), json);
  EXPECT_THROW(read_class_results(json.substr(9)), UserError);
  EXPECT_THROW(read_class_results("{\"schema\": \"x\"}"), UserError);
}

}  // namespace
}  // namespace meshgrade
