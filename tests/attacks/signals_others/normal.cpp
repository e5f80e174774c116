// Looks for processes that it could signal.
#include <unistd.h>
#include <csignal>

#include "attack.h"

void attack() {
  int found = 0;
  for (pid_t other = 1; other < 32768; ++other) {
    if (other != ::getpid() && other != ::getppid() && ::kill(other, 0) == 0) ++found;
  }
  // In a namespace of its own, there are the first process and the launcher.
  expect_refusal("signals", found > 3);
}
