// Changes the clock and the name of the machine.
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>
#include <ctime>

#include "attack.h"

void attack() {
  const timespec then{1, 0};
  expect_refusal("clock", ::clock_settime(CLOCK_REALTIME, &then) == 0);
  const timeval past{1, 0};
  expect_refusal("settimeofday", ::settimeofday(&past, nullptr) == 0);
  expect_refusal("sethostname", ::sethostname("evil", 4) == 0);
  expect_refusal("reboot", ::syscall(SYS_reboot, 0xfee1dead, 672274793, 0, nullptr) == 0);
}
