#include "grader/base/process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>

#include "grader/base/cancel.h"
#include "grader/base/errors.h"

namespace meshgrade {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

Command shell(const std::string& script) {
  Command command;
  command.arguments = {"sh", "-c", script};
  return command;
}

/// Runs a call and tells whether it was over long before `script`'s sleeps of 30 seconds.
template <class Call>
void expect_quick(Call call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  EXPECT_LT(std::chrono::steady_clock::now() - start, seconds(15));
}

TEST(Process, OutputAndStatusArriveFromBothStreams) {
  const ProcessResult result = run_process(shell("echo out; echo err >&2; exit 3"));
  EXPECT_EQ(result.output, "out\nerr\n");
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.signal, 0);
  EXPECT_FALSE(result.ok());
  EXPECT_TRUE(run_process(shell("true")).ok());
}

TEST(Process, InputIsWhatWasGiven) {
  Command command = shell("cat");
  command.input = std::string(200'000, 'x') + "end";
  EXPECT_EQ(run_process(command).output, command.input);
}

TEST(Process, SignalIsReported) {
  const ProcessResult result = run_process(shell("kill -SEGV $$"));
  EXPECT_EQ(result.signal, SIGSEGV);
  EXPECT_FALSE(result.ok());
}

TEST(Process, RunsInItsFolder) {
  const ScratchFolder folder;
  Command command = shell("pwd");
  command.folder = folder.path();
  EXPECT_EQ(run_process(command).output, folder.path().string() + "\n");
}

TEST(Process, MissingProgramIsAGraderError) {
  Command command;
  command.arguments = {"meshgrade-no-such-program"};
  EXPECT_THROW(run_process(command), GraderError);
}

TEST(Process, StatusOfAShellThatFindsNothingIsAStatusLikeAnyOther) {
  EXPECT_EQ(run_process(shell("exit 127")).status, 127);
}

TEST(Process, TimeLimitEndsTheProgram) {
  Command command = shell("echo begun; exec sleep 30");
  command.time_limit = milliseconds(200);
  expect_quick([&] {
    const ProcessResult result = run_process(command);
    EXPECT_TRUE(result.timed_out);
    EXPECT_FALSE(result.ok());
    EXPECT_EQ(result.output, "begun\n");
  });
}

TEST(Process, TimeLimitHoldsForAProgramThatClosedItsOutput) {
  Command command = shell("exec >&- 2>&-; exec sleep 30");
  command.time_limit = milliseconds(200);
  expect_quick([&] { EXPECT_TRUE(run_process(command).timed_out); });
}

TEST(Process, TimeLimitEndsWhatTheProgramStartedAsWell) {
  const ScratchFolder folder;
  Command command = shell("(sleep 1; touch survived) & sleep 30");
  command.folder = folder.path();
  command.time_limit = milliseconds(200);
  EXPECT_TRUE(run_process(command).timed_out);
  std::this_thread::sleep_for(milliseconds(1300));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "survived"));
}

TEST(Process, NothingIsLeftBehindAfterAnEarlyEnd) {
  const ScratchFolder folder;
  Command command = shell("(sleep 1; touch survived) >/dev/null 2>&1 & exit 0");
  command.folder = folder.path();
  EXPECT_TRUE(run_process(command).ok());
  std::this_thread::sleep_for(milliseconds(1300));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "survived"));
}

TEST(Process, OutputBeyondTheLimitIsDroppedAndTheProgramGoesOn) {
  Command command = shell("head -c 3000000 /dev/zero | tr '\\0' x; exit 5");
  command.kept_output = 1000;
  const ProcessResult result = run_process(command);
  EXPECT_EQ(result.output, std::string(1000, 'x'));
  EXPECT_EQ(result.status, 5);
}

TEST(Process, OnlyNamedDescriptorsAreShared) {
  FileDescriptor named = make_scratch_file();
  const int low = ::open("/dev/null", O_RDONLY);  // without close-on-exec, on purpose
  const int high = ::fcntl(low, F_DUPFD, 300);
  ASSERT_GE(high, 300);
  Command command = shell("ls /proc/$$/fd; echo through >&3");
  command.shared_files = {named.get()};
  const ProcessResult result = run_process(command);
  ::close(low);
  ::close(high);
  std::istringstream words(result.output);
  std::vector<std::string> open;
  for (std::string word; words >> word;) {
    // The shell keeps a copy of what it redirects, from 10 on.
    if (word != "10") open.push_back(word);
  }
  EXPECT_EQ(open, (std::vector<std::string>{"0", "1", "2", "3"}));
  char text[8] = {};
  EXPECT_EQ(::pread(named.get(), text, sizeof text, 0), 8);
  EXPECT_EQ(std::string(text, 8), "through\n");
}

TEST(Process, SharedFilesKeepTheirOrder) {
  std::vector<FileDescriptor> files;
  Command command = shell("echo a >&3; echo b >&4; echo c >&5");
  for (int i = 0; i < 3; ++i)
    files.push_back(make_scratch_file());
  for (const std::size_t i : {2U, 0U, 1U})
    command.shared_files.push_back(files[i].get());
  ASSERT_TRUE(run_process(command).ok());
  std::string letters;
  for (const FileDescriptor& file : files) {
    char letter = 0;
    EXPECT_EQ(::pread(file.get(), &letter, 1, 0), 1);
    letters += letter;
  }
  EXPECT_EQ(letters, "bca");
}

TEST(ScratchFolder, IsPrivateAndDeletesItselfWithAllItHolds) {
  std::filesystem::path path;
  {
    const ScratchFolder folder;
    path = folder.path();
    std::filesystem::create_directories(path / "a" / "b");
    std::ofstream(path / "a" / "b" / "c") << "text";
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0700U);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ScratchFolder, MovesWithItsContents) {
  ScratchFolder first;
  const std::filesystem::path path = first.path();
  {
    const ScratchFolder second(std::move(first));
    EXPECT_EQ(second.path(), path);
    EXPECT_TRUE(std::filesystem::exists(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

#ifdef __linux__
TEST(Process, MemoryOfAllProcessesTogetherIsLimited) {
  Command command = shell(
      "for i in 1 2 3; do (x=$(head -c 30000000 /dev/zero | tr '\\0' x); sleep 30) & done; "
      "wait");
  command.most_memory = 70'000'000;
  expect_quick([&] {
    const ProcessResult result = run_process(command);
    EXPECT_TRUE(result.out_of_memory);
    EXPECT_FALSE(result.timed_out);
    EXPECT_FALSE(result.ok());
  });
}

TEST(Process, NumberOfProcessesIsLimited) {
  Command command = shell("for i in 1 2 3 4 5 6 7 8 9; do sleep 30 & done; wait");
  command.most_processes = 6;
  expect_quick([&] { EXPECT_TRUE(run_process(command).too_many_processes); });
  command.most_processes = 20;
  command.time_limit = milliseconds(300);
  EXPECT_FALSE(run_process(command).too_many_processes);
}
#endif

TEST(Process, ProgramThatSaysTooMuchIsStopped) {
  Command command = shell("while :; do echo noise; done");
  command.most_output = 100'000;
  command.kept_output = 1000;
  expect_quick([&] {
    const ProcessResult result = run_process(command);
    EXPECT_TRUE(result.too_much_output);
    EXPECT_EQ(result.output.size(), 1000U);
  });
}

TEST(Process, EnvironmentIsReplacedOnlyWhereOneIsGiven) {
  ::setenv("MESHGRADE_TEST", "here", 1);
  Command command = shell("echo $MESHGRADE_TEST");
  EXPECT_EQ(run_process(command).output, "here\n");
  command.environment = {"MESHGRADE_TEST=there"};
  EXPECT_EQ(run_process(command).output, "there\n");
  ::unsetenv("MESHGRADE_TEST");
}

TEST(Process, IsEndedWhenItsResultIsNotWantedAnyMore) {
  expect_quick([] {
    std::optional<Cancellation> cancellation;
    std::thread other([&] {
      std::this_thread::sleep_for(milliseconds(100));
      cancellation.emplace();
    });
    EXPECT_THROW(run_process(shell("sleep 30")), Cancelled);
    other.join();
    cancellation.reset();
    EXPECT_EQ(run_process(shell("echo on")).output, "on\n");
  });
}

}  // namespace
}  // namespace meshgrade
