// Pushes itself ahead of others.
#include <sched.h>
#include <sys/resource.h>

#include "attack.h"

void attack() {
  expect_refusal("setpriority", ::setpriority(PRIO_PROCESS, 0, -20) == 0);
  sched_param most{1};
  expect_refusal("scheduler", ::sched_setscheduler(0, SCHED_FIFO, &most) == 0);
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(0, &one);
  expect_refusal("affinity", ::sched_setaffinity(0, sizeof one, &one) == 0);
}
