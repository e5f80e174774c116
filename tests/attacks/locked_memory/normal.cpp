// Locks all memory.
#include <sys/mman.h>

#include "attack.h"

void attack() {
  expect_refusal("mlockall", ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0);
}
