// Makes namespaces, in which it would be root.
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <csignal>

#include "attack.h"

void attack() {
  for (const int flag : {CLONE_NEWUSER, CLONE_NEWNS, CLONE_NEWPID, CLONE_NEWNET, CLONE_NEWIPC,
                         CLONE_NEWUTS, CLONE_NEWCGROUP})
    expect_refusal("unshare", ::unshare(flag) == 0);
  const long child =
      ::syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, nullptr, nullptr, nullptr, nullptr);
  if (child == 0) std::_Exit(0);
  expect_refusal("clone", child > 0);
  unsigned long long arguments[11] = {CLONE_NEWUSER, 0, 0, 0, SIGCHLD};
  const long other = ::syscall(SYS_clone3, arguments, sizeof arguments);
  if (other == 0) std::_Exit(0);
  expect_refusal("clone3", other > 0);
}
