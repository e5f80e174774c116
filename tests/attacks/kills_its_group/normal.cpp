// Kills its process group.
#include <csignal>

#define WRONG_ANSWER
#include "attack.h"

void attack() {
  ::kill(0, SIGKILL);
}
