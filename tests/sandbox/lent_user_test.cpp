#include "grader/sandbox/lent_user.h"

#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

TEST(LentUser, NoTwoRunsHaveTheSame) {
  if (::geteuid() != 0) {
    EXPECT_THROW(LentUser(), GraderError);
    return;
  }
  const LentUser first;
  const LentUser second;
  EXPECT_NE(first.number(), second.number());
  EXPECT_EQ(::getpwuid(first.number()), nullptr);
}

TEST(LentUser, UserIsFreeAgainAfterItsRun) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can lend users";
  uid_t before = 0;
  {
    const LentUser user;
    before = user.number();
  }
  // Others may be lent meanwhile, but not all of them.
  bool found = false;
  for (int i = 0; i < 20 && !found; ++i)
    found = LentUser().number() == before;
  EXPECT_TRUE(found);
}

/// As of a grader in another container, whose locks are not seen here.
TEST(LentUser, UserWithProcessesIsNotLent) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can lend users";
  uid_t busy = 0;
  {
    const LentUser user;
    busy = user.number();
  }
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t other = ::fork();
  if (other == 0) {
    const bool is_other = ::setresuid(busy, busy, busy) == 0;
    (void)!::write(ready[1], &is_other, 1);
    for (;;)
      ::pause();
  }
  bool is_other = false;
  EXPECT_EQ(::read(ready[0], &is_other, 1), 1);
  EXPECT_TRUE(is_other);
  EXPECT_NE(LentUser().number(), busy);
  ::kill(other, SIGKILL);
  ::waitpid(other, nullptr, 0);
  EXPECT_EQ(LentUser().number(), busy) << "ended, it is in nobody's way";
}

TEST(LentFolder, BelongsToTheUserAndThenToNobodyElse) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give folders away";
  const ScratchFolder scratch;
  const LentUser user;
  struct stat status {};
  {
    const LentFolder folder(scratch.path(), user);
    ASSERT_EQ(::stat(scratch.path().c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, user.number());
    EXPECT_EQ(status.st_mode & 0777U, 0700U);
  }
  ASSERT_EQ(::stat(scratch.path().c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 0U);
  EXPECT_EQ(status.st_mode & 0077U, 0U);
}

}  // namespace
}  // namespace meshgrade
