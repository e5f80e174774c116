// What a confined program can and cannot do, on each layer that works here. The attacks in
// tests/attacks prove the same with real submissions.

#include "grader/sandbox/confined_run.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

class ConfinedRun : public testing::TestWithParam<Layer> {
 protected:
  void SetUp() override {
    sandbox_ = find_sandbox(MESHGRADE_KIT_DIR, MESHGRADE_COMPILER, GetParam());
    if (sandbox_.layer == GetParam()) return;
    for (const Probe& probe : sandbox_.probes) {
      if (!probe.works) std::cout << probe.name << ": " << probe.detail << "\n";
    }
    GTEST_SKIP() << "layer " << layer_name(GetParam()) << " does not work on this machine";
  }

  ProcessResult run(const std::string& script, Bounds bounds = {}) const {
    Command command;
    command.arguments = {"sh", "-c", script};
    command.folder = folder_.path();
    command.time_limit = std::chrono::seconds(20);
    bounds.compiles = true;
    return run_confined(sandbox_, std::move(command), bounds);
  }

  ScratchFolder folder_;
  Sandbox sandbox_;
};

/// How a start fails that another program has ended, or that has no memory.
TEST(ConfinedStart, FailureWithoutAWordIsExplained) {
  const ScratchFolder folder;
  const auto message = [&](const std::string& script) {
    Sandbox sandbox;
    sandbox.layer = Layer::kSameUser;
    sandbox.launcher = folder.path() / "launcher";
    std::ofstream(sandbox.launcher) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(sandbox.launcher, fs::perms::owner_all);
    Command command;
    command.arguments = {"/usr/bin/c++"};
    command.folder = folder.path();
    try {
      run_confined(sandbox, std::move(command), {});
    } catch (const GraderError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("exit 3"),
            "the sandbox cannot start /usr/bin/c++: it ended with exit status 3 and said "
            "nothing");
  EXPECT_EQ(message("kill -KILL $$"),
            "the sandbox cannot start /usr/bin/c++: it was ended by a signal (Killed) before "
            "it began: the machine has no memory left, or another program ended it");
}

TEST_P(ConfinedRun, OutputStatusAndSignalArrive) {
  const ProcessResult ended = run("echo out; echo err >&2; exit 3");
  EXPECT_EQ(ended.output, "out\nerr\n");
  EXPECT_EQ(ended.status, 3);
  EXPECT_EQ(run("kill -SEGV $$").signal + run("kill -SEGV $$").status % 128, 11);
}

TEST_P(ConfinedRun, FolderCanBeWrittenOnlyWhereThatIsAllowed) {
  EXPECT_FALSE(run("echo text > made.txt").ok());
  EXPECT_FALSE(fs::exists(folder_.path() / "made.txt"));
  Bounds bounds;
  bounds.writes_folder = true;
  EXPECT_TRUE(run("echo text > made.txt", bounds).ok());
  EXPECT_TRUE(fs::exists(folder_.path() / "made.txt"));
}

TEST_P(ConfinedRun, FolderBelongsToThisProcessAgainAfterwards) {
  run("true");
  struct stat status {};
  ASSERT_EQ(::stat(folder_.path().c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, ::geteuid());
  EXPECT_EQ(status.st_mode & 077U, 0U);
}

TEST_P(ConfinedRun, OnlyNamedFilesCanBeRead) {
  const ScratchFolder other;
  ::chmod(other.path().c_str(), 0755);
  std::ofstream(other.path() / "file.txt") << "text";
  const std::string script = "cat " + (other.path() / "file.txt").string();
  if (GetParam() == Layer::kNamespaces || sandbox_.bounds_files) {
    EXPECT_FALSE(run(script).ok());
  }
  Bounds bounds;
  bounds.readable = {other.path()};
  EXPECT_EQ(run(script, bounds).output, "text");
}

TEST_P(ConfinedRun, EnvironmentHoldsNothingOfThisProcess) {
  ::setenv("MESHGRADE_SECRET", "token", 1);
  EXPECT_EQ(run("env").output.find("token"), std::string::npos);
  ::unsetenv("MESHGRADE_SECRET");
}

TEST_P(ConfinedRun, WhatIsLeftRunningIsEnded) {
  Bounds bounds;
  bounds.writes_folder = true;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(
      run("setsid sh -c 'sleep 2; touch survived' >/dev/null 2>&1 & exit 0", bounds).ok());
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(1900));
  ::sleep(3);
  EXPECT_FALSE(fs::exists(folder_.path() / "survived"));
}

TEST_P(ConfinedRun, TimeLimitEndsWhatWasStartedToo) {
  Command command;
  command.arguments = {"sh", "-c", "setsid sh -c 'sleep 2; touch survived' & sleep 30"};
  command.folder = folder_.path();
  command.time_limit = std::chrono::milliseconds(300);
  Bounds bounds;
  bounds.compiles = true;
  bounds.writes_folder = true;
  EXPECT_TRUE(run_confined(sandbox_, command, bounds).timed_out);
  ::sleep(3);
  EXPECT_FALSE(fs::exists(folder_.path() / "survived"));
}

TEST_P(ConfinedRun, LimitsHold) {
  Bounds bounds;
  bounds.writes_folder = true;
  bounds.file_bytes = 1000;
  bounds.open_files = 20;
  bounds.memory_bytes = 64 << 20;
  EXPECT_FALSE(run("head -c 5000 /dev/zero > large", bounds).ok());
  EXPECT_LE(fs::file_size(folder_.path() / "large"), 1000U);
  EXPECT_EQ(run("ulimit -n", bounds).output, "20\n");
  EXPECT_FALSE(run("head -c 200000000 /dev/zero | tail -c 199999999", bounds).ok());
  EXPECT_EQ(run("ulimit -c", bounds).output, "0\n");
}

/// The system's own limit, as a program sees it that an ordinary user has confined.
std::string process_limit_of(uid_t user, const Sandbox& sandbox, const fs::path& folder) {
  const FileDescriptor answer = make_scratch_file();
  const pid_t child = ::fork();
  if (child == 0) {
    if (::setgid(user) != 0 || ::setuid(user) != 0) ::_exit(1);
    Command command;
    command.arguments = {"bash", "-c", "ulimit -u"};
    command.folder = folder;
    Bounds bounds;
    bounds.compiles = true;
    bounds.processes = 10;
    const std::string text = run_confined(sandbox, std::move(command), bounds).output;
    ::_exit(::write(answer.get(), text.data(), text.size()) < 0 ? 1 : 0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  char text[64] = {};
  return ::pread(answer.get(), text, sizeof text - 1, 0) > 0 && status == 0 ? text : "";
}

TEST(ConfinedRunOfAnOrdinaryUser, ProcessesHaveALimitOfTheSystem) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become another user";
  Sandbox sandbox = find_sandbox(MESHGRADE_KIT_DIR, MESHGRADE_COMPILER, Layer::kSameUser);
  const ScratchFolder folder;
  ::chmod(folder.path().c_str(), 0755);
  // Where everybody can reach it.
  fs::copy_file(sandbox.launcher, folder.path() / "launcher");
  sandbox.launcher = folder.path() / "launcher";
  const std::string limit = process_limit_of(61'234, sandbox, folder.path());
  ASSERT_FALSE(limit.empty());
  EXPECT_GT(std::stoul(limit), 1010U);  // who has no other program running but the test
  EXPECT_LT(std::stoul(limit), 1020U);
}

TEST_P(ConfinedRun, ProgramThatIsNotThereIsAnErrorOfTheGrader) {
  Command command;
  command.arguments = {"no-such-program"};
  command.folder = folder_.path();
  EXPECT_THROW(run_confined(sandbox_, command, {}), GraderError);
}

TEST_P(ConfinedRun, BrokenSandboxIsAnErrorOfTheGraderAndRunsNothing) {
  Sandbox broken = sandbox_;
  broken.launcher = "/bin/false";
  Command command;
  command.arguments = {"touch", (folder_.path() / "ran").string()};
  command.folder = folder_.path();
  EXPECT_THROW(run_confined(broken, command, {}), GraderError);
  EXPECT_FALSE(fs::exists(folder_.path() / "ran"));
}

std::string test_name(const testing::TestParamInfo<Layer>& info) {
  return "Layer" + std::to_string(static_cast<int>(info.param));
}

INSTANTIATE_TEST_SUITE_P(Layers, ConfinedRun,
                         testing::Values(Layer::kNamespaces, Layer::kOtherUser,
                                         Layer::kSameUser),
                         test_name);

}  // namespace
}  // namespace meshgrade
