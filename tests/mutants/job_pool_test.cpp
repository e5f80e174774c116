#include "grader/mutants/job_pool.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <set>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

void ignore(std::size_t /*done*/) {}

TEST(JobPool, ResultsComeInTheOrderOfTheJobs) {
  const auto results = run_jobs(
      50, 3, [](std::size_t i) { return std::string(i * 5000, 'x'); }, ignore);
  ASSERT_EQ(results.size(), 50U);
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_EQ(results[i].size(), i * 5000);
}

TEST(JobPool, JobsRunInOtherProcesses) {
  const auto results = run_jobs(
      8, 2, [](std::size_t) { return std::to_string(::getpid()); }, ignore);
  const std::set<std::string> processes(results.begin(), results.end());
  EXPECT_EQ(processes.count(std::to_string(::getpid())), 0U);
  EXPECT_LE(processes.size(), 2U);
}

TEST(JobPool, AnExceptionOfAJobComesBack) {
  const auto fail = [](std::size_t i) -> std::string {
    if (i == 3) throw GraderError("number 3");
    return "";
  };
  EXPECT_THROW(run_jobs(8, 2, fail, ignore), GraderError);
}

TEST(JobPool, ADeadProcessIsNoticed) {
  const auto die = [](std::size_t) -> std::string { ::_exit(0); };
  EXPECT_THROW(run_jobs(2, 2, die, ignore), GraderError);
}

TEST(JobPool, NoJobsGiveNoResults) {
  EXPECT_TRUE(run_jobs(
                  0, 2, [](std::size_t) { return std::string(); }, ignore)
                  .empty());
}

}  // namespace
}  // namespace meshgrade
