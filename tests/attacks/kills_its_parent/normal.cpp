// Kills the process that watches over it.
#include <unistd.h>
#include <csignal>

#define WRONG_ANSWER
#include "attack.h"

void attack() {
  ::kill(::getppid(), SIGKILL);
  for (;;)
    ::sleep(1);
}
