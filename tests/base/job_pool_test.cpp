#include "grader/base/job_pool.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <set>

#include "grader/base/errors.h"
#include "grader/base/text.h"

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

/// Does `count` jobs in two processes. @return which were done, and what was said of the others
std::string ends_of(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::vector<std::string> ends(count);
  JobPool pool;
  pool.processes = 2;
  pool.work = [&](std::size_t job, unsigned) {
    work(job);
    return std::string("done");
  };
  pool.ended = [&](const JobEnd& end) { ends[end.job] = end.text; };
  EXPECT_TRUE(do_jobs(count, pool));
  return join(ends, "; ");
}

TEST(JobPool, TheDeathOfAJobIsOnlyItsOwn) {
  EXPECT_EQ(ends_of(5,
                    [](std::size_t job) {
                      if (job == 0) ::raise(SIGKILL);
                      if (job == 2) ::_exit(7);
                      if (job == 4) throw GraderError("number 4");
                    }),
            "its process died: Killed; done; its process ended with status 7; done; number 4");
}

TEST(JobPool, JobsThatRunAtOnceHaveDifferentNumbers) {
  JobPool pool;
  pool.processes = 3;
  pool.work = [](std::size_t, unsigned process) {
    return std::to_string(process) + " " + std::to_string(::getpid());
  };
  std::map<std::string, std::set<std::string>> processes;
  pool.ended = [&](const JobEnd& end) {
    const auto space = end.text.find(' ');
    processes[end.text.substr(0, space)].insert(end.text.substr(space));
  };
  EXPECT_TRUE(do_jobs(50, pool));
  for (const auto& [number, ids] : processes) {
    EXPECT_LT(std::stoi(number), 3);
    EXPECT_EQ(ids.size(), 1U);
  }
}

TEST(JobPool, AStopKillsWhatIsUnderWay) {
  JobPool pool;
  pool.work = [](std::size_t, unsigned) {
    ::sleep(1000);
    return std::string();
  };
  pool.ended = [](const JobEnd& end) { ADD_FAILURE() << end.job << ": " << end.text; };
  pool.stop = [] { return true; };
  EXPECT_FALSE(do_jobs(3, pool));
}

TEST(JobPool, NoJobsGiveNoResults) {
  EXPECT_TRUE(run_jobs(
                  0, 2, [](std::size_t) { return std::string(); }, ignore)
                  .empty());
}

}  // namespace
}  // namespace meshgrade
