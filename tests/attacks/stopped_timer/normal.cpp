// Takes away the timer of the processor time, and loops.
#include <sys/time.h>
#include <csignal>

#include "attack.h"

void attack() {
  itimerval never{};
  ::setitimer(ITIMER_PROF, &never, nullptr);
  std::signal(SIGPROF, SIG_IGN);
  std::signal(SIGXCPU, SIG_IGN);
  for (;;) {
  }
}
