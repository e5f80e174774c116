// Sends itself alarms.
#include <sys/time.h>

#include "attack.h"

void attack() {
  itimerval often{};
  often.it_interval.tv_usec = 1;
  often.it_value.tv_usec = 1;
  ::setitimer(ITIMER_REAL, &often, nullptr);
  for (;;) {
  }
}
