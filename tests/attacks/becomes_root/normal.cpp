// Takes back the rights that were given up.
#include <grp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  for (const char* name : {"setuid"}) {
    if (::getuid() == 0) continue;  // layer 3, run by root: there is nothing to take back
    expect_refusal(name, ::setuid(0) == 0);
    expect_refusal("setresuid", ::setresuid(0, 0, 0) == 0);
    expect_refusal("setgid", ::setgid(0) == 0);
    const gid_t root = 0;
    expect_refusal("setgroups", ::setgroups(1, &root) == 0);
    expect_refusal("setuid of another", ::setuid(1000) == 0);
  }
  expect_refusal("no new privileges", ::prctl(PR_SET_NO_NEW_PRIVS, 0, 0, 0, 0) == 0);
  expect_refusal("no seccomp", ::prctl(PR_GET_SECCOMP, 0, 0, 0, 0) == 0);
}
