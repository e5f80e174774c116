// `batch --slurm` on a cluster of two nodes, which these tests start on this machine.

#include "grader/cluster/slurm.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <thread>

#include "tests/cluster/small_class.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string kScript = MESHGRADE_SOURCE_DIR "/tests/cluster/slurm_cluster.sh";

class Slurm : public SmallClass {
 protected:
  void SetUp() override {
    if (::geteuid() != 0) GTEST_SKIP() << "starting a Slurm cluster takes root";
    if (run({"sh", "-c", "command -v slurmctld slurmd munged"}).status != 0)
      GTEST_SKIP() << "slurm-wlm and munge are not installed";
    started_ = true;
    // munge insists on it.
    fs::permissions(scratch_.path(), fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add);
    const ProcessResult said = run({kScript, "start", cluster_.string()});
    ASSERT_TRUE(said.ok()) << said.output;
    ::setenv("SLURM_CONF", (cluster_ / "slurm.conf").c_str(), 1);
  }

  void TearDown() override {
    if (started_) run({kScript, "stop", cluster_.string()});
    ::unsetenv("SLURM_CONF");
  }

  std::vector<std::string> slurm_command() const {
    return batch_command({"--slurm", "--per-task", "2"});
  }

  /// How many results are there.
  std::size_t finished() const {
    std::size_t count = 0;
    std::error_code error;
    for (fs::directory_iterator one(results_ / "results", error), end; !error && one != end;
         one.increment(error)) {
      count += fs::exists(one->path() / "result.json") ? 1 : 0;
    }
    return count;
  }

  void wait_for_results(std::size_t count) const {
    for (int i = 0; i < 1200 && finished() < count; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ASSERT_GE(finished(), count);
  }

  /// Starts the batch and does not wait for it.
  pid_t begin() const {
    const std::vector<std::string> words = slurm_command();
    std::vector<char*> arguments;
    for (const std::string& word : words)
      arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
      ::execv(arguments[0], arguments.data());
      ::_exit(127);
    }
    return child;
  }

  static int wait_for(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  fs::path cluster_ = scratch_.path() / "cluster";
  bool started_ = false;
};

TEST_F(Slurm, GradesAsOneMachineDoes) {
  hand_in(8);
  const ProcessResult said = run(slurm_command());
  EXPECT_EQ(said.status, 1) << "one hand-in is empty";
  EXPECT_THAT(said.output, HasSubstr("4 tasks for 8 hand-ins"));
  EXPECT_THAT(said.output, HasSubstr("8 of 9 hand-ins graded, 1 ungradable"));
  EXPECT_FALSE(fs::exists(results_ / ".tasks"));
  const ProcessResult again = run(slurm_command());
  EXPECT_THAT(again.output, testing::Not(HasSubstr("tasks for"))) << "all is unchanged";
  const std::string by_slurm = grades();
  EXPECT_EQ(by_slurm, grades_without_cluster());
}

TEST_F(Slurm, LosesNothingWhenANodeIsLost) {
  hand_in(16, 10);
  const pid_t batch = begin();
  wait_for_results(3);
  EXPECT_TRUE(run({kScript, "lose", cluster_.string(), "n2"}).ok());
  EXPECT_EQ(wait_for(batch), 1) << "one hand-in is empty";
  EXPECT_EQ(finished(), 17U);
  const std::string by_slurm = grades();
  EXPECT_EQ(by_slurm, grades_without_cluster());
}

TEST_F(Slurm, GoesOnWithTheSameJobAfterItsLeaderWasKilled) {
  hand_in(12, 10);
  const pid_t batch = begin();
  wait_for_results(2);
  ::kill(batch, SIGKILL);
  EXPECT_EQ(wait_for(batch), -SIGKILL);
  const ProcessResult said = run(slurm_command());
  EXPECT_THAT(said.output, HasSubstr("following job 1, which is at work already"));
  EXPECT_THAT(said.output, HasSubstr("12 of 13 hand-ins graded"));
}

TEST_F(Slurm, AnInterruptCancelsTheJob) {
  hand_in(12, 20);
  const pid_t batch = begin();
  wait_for_results(2);
  ::kill(batch, SIGINT);
  EXPECT_EQ(wait_for(batch), 130);
  for (int i = 0; i < 200 && tasks_left("1") != std::size_t{0}; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(tasks_left("1"), std::size_t{0});
}

TEST_F(Slurm, ARefusedJobIsSaidWithSlurmsReason) {
  hand_in(1);
  const ProcessResult said = run(batch_command({"--slurm", "--sbatch=--partition=nowhere"}));
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("sbatch refused the job"));
  EXPECT_THAT(said.output, HasSubstr("nvalid partition"));
}

}  // namespace
}  // namespace meshgrade
