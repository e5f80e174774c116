// Leaves a process that keeps the output open and ignores signals.
#include <unistd.h>
#include <csignal>

#include "attack.h"

void attack() {
  if (::fork() != 0) return;
  ::setsid();
  for (int i = 1; i < 32; ++i)
    std::signal(i, SIG_IGN);
  for (;;)
    ::sleep(1);
}
