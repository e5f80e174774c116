// Kills every process that it may.
#include <csignal>

#include "attack.h"

void attack() {
  expect_refusal("kill(-1)", ::kill(-1, SIGKILL) == 0);
}
