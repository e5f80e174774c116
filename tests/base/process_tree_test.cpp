#include "grader/base/process_tree.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <latch>
#include <thread>
#include <vector>

namespace meshgrade {
namespace {

TEST(ProcessTree, ThreadsAndProcessesOfAUserAreCounted) {
  if (processes_of_user(::getuid()) == 0) GTEST_SKIP() << "this system does not tell";
  const pid_t child = ::fork();
  if (child == 0) {
    if (::geteuid() == 0 && ::setuid(61'235) != 0) ::_exit(100);
    const std::size_t before = processes_of_user(::getuid());
    std::latch done(1);
    std::vector<std::thread> threads;
    for (int i = 0; i < 5; ++i)
      threads.emplace_back([&done] { done.wait(); });
    const std::size_t with_threads = processes_of_user(::getuid());
    done.count_down();
    for (std::thread& thread : threads)
      thread.join();
    ::_exit(before == 0 ? 101 : static_cast<int>(with_threads - before));
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  // An ordinary user's other programs come and go; root becomes somebody who has none.
  if (::geteuid() == 0) {
    EXPECT_EQ(WEXITSTATUS(status), 5);
  } else {
    EXPECT_LT(WEXITSTATUS(status), 100);
  }
}

TEST(ProcessTree, UseOfATreeCountsItsThreads) {
  if (use_of_tree(::getpid()).processes == 0) GTEST_SKIP() << "this system does not tell";
  const std::size_t before = use_of_tree(::getpid()).processes;
  std::latch done(1);
  std::thread thread([&done] { done.wait(); });
  EXPECT_EQ(use_of_tree(::getpid()).processes, before + 1);
  done.count_down();
  thread.join();
}

}  // namespace
}  // namespace meshgrade
